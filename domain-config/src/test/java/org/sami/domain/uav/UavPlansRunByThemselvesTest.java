package org.sami.domain.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.Turns;

/** Plans of aircraft that are run on by themselves, as by Run in DREAMM's Try it: aircraft, services and operator take turns until the mission ends. */
class UavPlansRunByThemselvesTest {
    private static final int MOST_STEPS = 400;
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/uav").orThrow();

    private static Stream<Arguments> plans() {
        return LIBRARY.plans().stream()
                .flatMap(plan -> Stream.of(1, 3).map(locations -> Arguments.of(plan.id(), locations)));
    }

    @ParameterizedTest
    @MethodSource("plans")
    void everyPlanRunsToItsEnd(String plan, int locations) {
        Engine engine = new Engine(LIBRARY.vocabulary(), LIBRARY.projectOf(plan).orElseThrow());
        Stepper stepper = Stepper.start(engine, plan, plan, List.of("kite", "gull", "rook"));
        List<String> taken = new ArrayList<>();
        boolean goesOn = true;
        while (goesOn && taken.size() < MOST_STEPS && stepper.outcome().isEmpty()) {
            Turns.Turn turn = Turns.next(stepper, List.of(locations), true, true);
            turn.step().ifPresent(next -> {
                taken.add(next.step().toString());
                stepper.take(next.step());
            });
            goesOn = turn.step().isPresent();
        }

        assertThat(stepper.outcome()).as("%s", taken).contains(Outcome.ENDED);
    }
}
