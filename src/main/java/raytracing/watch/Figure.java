package raytracing.watch;

import java.util.List;
import java.util.Locale;
import raytracing.parse.Printable;

/** One thing that is known about a picture, in words for people and as a JSON value (RFC 8259) for programs. */
sealed interface Figure {
    /** For people, with its unit. */
    String text();

    /** For programs, in the unit that its group is named after. */
    String json();

    /** A name. */
    record Name(String name) implements Figure {
        @Override
        public String text() {
            return Printable.of(name);
        }

        @Override
        public String json() {
            return quoted(name);
        }
    }

    /** A number of things. */
    record Count(long count) implements Figure {
        @Override
        public String text() {
            return String.format(Locale.ROOT, "%,d", count);
        }

        @Override
        public String json() {
            return String.valueOf(count);
        }
    }

    /** A part of a whole, from 0 to 1. */
    record Share(double share) implements Figure {
        /** So much of so many; of nothing, nothing. */
        static Share of(long part, long whole) {
            return new Share(whole == 0 ? 0 : (double) part / whole);
        }

        @Override
        public String text() {
            return String.format(Locale.ROOT, "%.1f %%", 100 * share);
        }

        @Override
        public String json() {
            return String.valueOf(share);
        }
    }

    /** A time. */
    record Milliseconds(long nanoseconds) implements Figure {
        private static final double MILLION = 1e6;

        @Override
        public String text() {
            return String.format(Locale.ROOT, "%,.1f", nanoseconds / MILLION);
        }

        @Override
        public String json() {
            return String.valueOf(nanoseconds / MILLION);
        }
    }

    /** Some numbers that belong together. */
    record Numbers(List<? extends Number> numbers) implements Figure {
        @Override
        public String text() {
            StringBuilder text = new StringBuilder();
            for (Number number : numbers) {
                text.append(text.isEmpty() ? "" : " ")
                    .append(number instanceof Double ? String.format(Locale.ROOT, "%.3f", number) : number);
            }
            return text.toString();
        }

        @Override
        public String json() {
            return numbers.toString();
        }
    }

    /** A JSON string. */
    static String quoted(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (char c : text.toCharArray()) {
            if (c == '"' || c == '\\') {
                quoted.append('\\').append(c);
            } else if (c < ' ') {
                quoted.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                quoted.append(c);
            }
        }
        return quoted.append('"').toString();
    }
}
