package raytracing.color;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class MutableColorTest {
    private static final double HUGE = 1e200;

    private static MutableColor mutable(double red, double green, double blue) {
        MutableColor color = new MutableColor();
        color.set(red, green, blue);
        return color;
    }

    @Test
    void productsOfLightAreAddedChannelByChannel() {
        MutableColor sum = mutable(1, 2, 3);
        sum.add(0.5, new Color(1, 2, 4), new Color(8, 1, 0));
        assertEquals(new Color(5, 3, 3), sum.toColor());
    }

    @Test
    void colorsThatChangeAreAddedLikeThoseThatDoNot() {
        Color weight = new Color(0.1, 0.2, 0.3);
        Color light = new Color(0.7, 0.9, 1.1);
        MutableColor sameWeight = mutable(0.1, 0.2, 0.3);
        MutableColor sameLight = mutable(0.7, 0.9, 1.1);
        MutableColor expected = new MutableColor();
        expected.add(0.3, weight, light);
        for (int i = 0; i < 3; i++) {
            MutableColor sum = new MutableColor();
            switch (i) {
                case 0 -> sum.add(0.3, weight, sameLight);
                case 1 -> sum.add(0.3, sameWeight, light);
                default -> sum.add(0.3, sameWeight, sameLight);
            }
            assertEquals(expected.toColor(), sum.toColor());
        }
    }

    @Test
    void filtersWorkChannelByChannel() {
        MutableColor weight = new MutableColor();
        weight.setProduct(mutable(1, 0.5, 0), new Color(0.25, 1, 4));
        assertEquals(new Color(0.25, 0.5, 0), weight.toColor());
        weight.scale(0.5);
        assertEquals(new Color(0.125, 0.25, 0), weight.toColor());
    }

    /** Infinity times 0 would be NaN. */
    @Test
    void aFactorOf0Gives0WhateverItMeets() {
        MutableColor overflow = mutable(HUGE, HUGE, 1);
        overflow.setProduct(overflow, new Color(HUGE, 1, 1));
        assertEquals(new Color(Double.MAX_VALUE, HUGE, 1), overflow.toColor());
        MutableColor product = new MutableColor();
        product.setProduct(overflow, new Color(0, 1, 1));
        assertEquals(new Color(0, HUGE, 1), product.toColor());
        MutableColor sum = new MutableColor();
        sum.add(HUGE, new Color(HUGE, HUGE, 1), new Color(0, HUGE, 1));
        assertEquals(new Color(0, Double.MAX_VALUE, HUGE), sum.toColor());
        sum.scale(0);
        assertEquals(Color.BLACK, sum.toColor());
    }

    @Test
    void theBrightestChannelIsTheMaximum() {
        assertEquals(1, mutable(1, 0.5, 0).max());
        assertEquals(3, mutable(1, 2, 3).max());
    }
}
