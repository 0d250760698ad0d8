package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.RunReport;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.InitialCharges;
import org.sami.crw.sim.run.settings.RunPlan;
import org.sami.crw.sim.run.settings.RunSettings;

/** Whoever is interrupted by what, and whenever: every location is visited, and the mission ends. */
@Tag("long")
class SeededInterruptsTest {
    private static final int RUNS = 30;
    private static final List<String> NAMES =
            List.of("recharge", "recharge:", "recharge:", "recharge:", "alarm", "alarm over");

    static IntStream seeds() {
        return IntStream.rangeClosed(1, RUNS);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void everyLocationIsVisitedAndTheMissionEnds(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int boats = random.nextInt(1, 6);
        int locations = random.nextInt(1, 16);
        List<String> interrupts = new ArrayList<>(List.of("recharge@battery"));
        for (int i = random.nextInt(1, 9); i > 0; i--) {
            interrupts.add(press(random, boats));
        }
        RunPlan plan = TestRuns.plan("clv-interrupts");
        RunSettings settings = RunSettings.of(
                        plan.plan().id(),
                        plan.plan().name(),
                        new FleetSettings(boats, locations, 300, seed).with(charges(random, boats)))
                .limitMillis(20_000_000)
                .answerAfterMillis(random.nextLong(20_000))
                .interrupts(interrupts)
                .build();

        RunReport report = TestRuns.run(plan, settings);

        String what = boats + " boats, " + locations + " locations, " + interrupts;
        assertThat(report.result().outcome())
                .as("%s: %s", what, report.result().reason())
                .isEqualTo(RunOutcome.ENDED);
        assertThat(report.locations()).as(what).hasSize(locations).allMatch(LocationResult::visited);
    }

    private static String press(SplittableRandom random, int boats) {
        String name = NAMES.get(random.nextInt(NAMES.size()));
        String boat = name.endsWith(":") ? String.valueOf(1 + random.nextInt(boats)) : "";
        return name + boat + String.format(Locale.ROOT, "@%.1f", random.nextDouble(400));
    }

    private static InitialCharges charges(SplittableRandom random, int boats) {
        return new InitialCharges(IntStream.range(0, boats)
                .mapToObj(i -> random.nextDouble(16, 100))
                .toList());
    }
}
