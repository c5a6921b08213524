package raytracing.compiled;

/**
 * The order in which some surfaces stand in the scene. A hierarchy finds them in another, and a sum of rounded shares
 * depends on it. One thread.
 */
final class SceneOrder {
    private int[] places = new int[16];

    /** Sorts surfaces with these numbers; they are few, and mostly in order already. */
    void sort(int[] numbers, int count) {
        if (count > places.length) {
            places = new int[2 * count];
        }
        for (int i = 0; i < count; i++) {
            int at = i;
            while (at > 0 && numbers[places[at - 1]] > numbers[i]) {
                places[at] = places[at - 1];
                at--;
            }
            places[at] = i;
        }
    }

    /** Which of them is the i-th in the scene. */
    int place(int i) {
        return places[i];
    }
}
