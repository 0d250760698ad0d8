package org.sami.crw.sim.run.settings;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * How full the batteries of a fleet are at the start.
 *
 * @param percents of full: none (all are full), one for all boats, or one for each, in order
 */
public record InitialCharges(List<Double> percents) {
    /** All batteries are full. */
    public static final InitialCharges FULL = new InitialCharges(List.of());

    /** Charges between empty and full. */
    public InitialCharges {
        percents = List.copyOf(percents);
        for (double percent : percents) {
            if (!(percent >= 0 && percent <= 100)) {
                throw new IllegalArgumentException("a battery's charge is 0 to 100 percent, not " + percent);
            }
        }
    }

    /**
     * Reads what {@link #toString} writes: percents with commas between them.
     *
     * @throws IllegalArgumentException where something is no charge
     */
    public static InitialCharges parse(String text) {
        List<Double> percents = new ArrayList<>();
        for (String part : text.split(",", -1)) {
            try {
                percents.add(Double.parseDouble(part.trim()));
            } catch (NumberFormatException e) {
                throw new IllegalArgumentException("a battery's charge is 0 to 100 percent, not '" + part + "'", e);
            }
        }
        return new InitialCharges(percents);
    }

    /** Whether it says something for a fleet of so many boats, all of them. */
    boolean fit(int boats) {
        return percents.size() <= 1 || percents.size() == boats;
    }

    /** The charge of a boat, counted from 0, in percent. */
    public double of(int boat) {
        if (percents.isEmpty()) {
            return 100;
        }
        return percents.size() == 1 ? percents.get(0) : percents.get(boat);
    }

    @Override
    public String toString() {
        return percents.stream().map(String::valueOf).collect(Collectors.joining(","));
    }
}
