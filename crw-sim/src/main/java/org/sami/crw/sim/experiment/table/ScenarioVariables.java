package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.SplittableRandom;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.hull.SensorKind;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InProcessBoats;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.TextNumbers;

/** The variables that say what a run's fleet and water are like. Whatever a file leaves out has the value that stands here. */
public final class ScenarioVariables {
    /** The usual values, by name. */
    public static final Map<String, String> USUAL = usual();

    private ScenarioVariables() {}

    private static Map<String, String> usual() {
        Map<String, String> usual = new LinkedHashMap<>();
        usual.put("boats", "3");
        usual.put("locations", "20");
        usual.put("area", "600");
        usual.put("range", "3500");
        usual.put("charge", "100..100");
        usual.put("discharge-interval", "600");
        usual.put("answer-after", "0");
        usual.put("alarm-length", "60");
        usual.put("conditions", "calm");
        usual.put("allocation", "auction");
        usual.put("sensor-rate", "0");
        usual.put("limit", "14400");
        return usual;
    }

    /** The value of a variable that has a usual value, so that it is never missing. */
    static String text(Map<String, String> variables, String name) {
        return Objects.requireNonNull(variables.get(name), name);
    }

    /** What is wrong with their values. */
    static List<Finding> check(Map<String, String> variables) {
        try {
            fleet(variables, 1);
            answerAfterMillis(variables);
            limitMillis(variables);
            AllocationCriterion.constant(text(variables, "allocation"));
            return List.of();
        } catch (IllegalArgumentException unfit) {
            return List.of(Finding.error("E-BAD-VALUE", "/settings", String.valueOf(unfit.getMessage())));
        }
    }

    /** The fleet of a run. */
    static FleetSettings fleet(Map<String, String> variables, long seed) {
        int boats = (int) number(variables, "boats", 1, FleetSettings.MOST_BOATS);
        return new FleetSettings(
                        boats,
                        (int) number(variables, "locations", 1, FleetSettings.MOST_LOCATIONS),
                        number(variables, "area", FleetSettings.SHORTEST_AREA_M, FleetSettings.LONGEST_AREA_M),
                        seed)
                .on(conditions(variables))
                .with(charges(variables, boats, seed))
                .withRangeM(
                        number(variables, "range", InProcessBoats.SHORTEST_RANGE_M, InProcessBoats.LONGEST_RANGE_M));
    }

    private static Conditions conditions(Map<String, String> variables) {
        Optional<NamedConditions> named = NamedConditions.named(text(variables, "conditions"));
        if (named.isEmpty()) {
            throw new IllegalArgumentException(
                    "conditions are calm, field, rough or logged, not '" + variables.get("conditions") + "'");
        }
        Conditions water = named.get().conditions();
        double hz = number(variables, "sensor-rate", 0, SensorSetting.MOST_HZ);
        return new Conditions(
                water.gpsNoiseM(),
                water.gpsJumpM(),
                water.compassNoiseDeg(),
                water.current(),
                water.wind(),
                hz > 0 ? List.of(new SensorSetting(SensorKind.TEMPERATURE, hz)) : List.of(),
                number(variables, "discharge-interval", 0, Conditions.LONGEST_DISCHARGE_INTERVAL_S));
    }

    /** The charges at the start, drawn between two limits; the same for equal seeds. */
    private static InitialCharges charges(Map<String, String> variables, int boats, long seed) {
        String text = text(variables, "charge");
        String[] ends = text.split("\\.\\.", -1);
        if (ends.length > 2) {
            throw new IllegalArgumentException("charge is MIN..MAX in percent, not '" + text + "'");
        }
        double least = number("charge", ends[0], 1, 100);
        double most = number("charge", ends[ends.length - 1], least, 100);
        SplittableRandom random = new SplittableRandom(seed ^ 0x63686172L);
        List<Double> percents = new ArrayList<>();
        for (int i = 0; i < boats; i++) {
            percents.add(least + (most - least) * random.nextDouble());
        }
        return least == 100 ? InitialCharges.FULL : new InitialCharges(percents);
    }

    static long answerAfterMillis(Map<String, String> variables) {
        return Math.round(number(variables, "answer-after", 0, 86_400) * 1000);
    }

    static long limitMillis(Map<String, String> variables) {
        return Math.round(number(variables, "limit", 1, 86_400) * 1000);
    }

    private static double number(Map<String, String> variables, String name, double least, double most) {
        return number(name, text(variables, name), least, most);
    }

    private static double number(String name, String text, double least, double most) {
        return TextNumbers.real(text, least, most)
                .orElseThrow(() -> new IllegalArgumentException(
                        name + " is a number from " + least + " to " + most + ", not '" + text + "'"));
    }
}
