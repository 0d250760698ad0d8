package org.sami.crw.cli.legacy;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.sami.crw.sim.run.settings.PlanInterrupts;

/**
 * Draws at which times of a trial run which interrupts are pressed: each independently of the others, at random distances, and
 * one for boats every second time for one boat, else for those that the operator chooses.
 */
final class RandomInterrupts {
    private static final double NAMES_A_BOAT = 0.5;

    private RandomInterrupts() {}

    /** The presses, as {@code --interrupt} takes them. */
    static List<String> draw(PlanInterrupts interrupts, List<String> boats, TrialSettings settings, long seed) {
        Random random = new Random(seed * 0x9E3779B97F4A7C15L + 0x1B873593L);
        List<String> presses = new ArrayList<>();
        for (String name : interrupts.names()) {
            double atMillis = 0;
            while (true) {
                atMillis -= Math.log(1 - random.nextDouble()) * settings.pressEveryMillis();
                if (atMillis >= settings.millis()) {
                    break;
                }
                boolean oneBoat = interrupts.takesBoats(name) && random.nextDouble() < NAMES_A_BOAT;
                String whom = oneBoat ? ":" + boats.get(random.nextInt(boats.size())) : "";
                presses.add(name + whom + String.format(Locale.ROOT, "@%.1f", atMillis / 1000));
            }
        }
        return presses;
    }
}
