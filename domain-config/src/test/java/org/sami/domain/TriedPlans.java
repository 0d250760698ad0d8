package org.sami.domain;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.sami.spn.engine.Engine;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.stepping.Turns;

/** Plans of boats for tests that try them: those of the library, and panoramas as authors drew them. */
final class TriedPlans {
    static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();

    private static final int MOST_STEPS = 400;

    private TriedPlans() {}

    static Stream<Map.Entry<Project, Plan>> library() {
        return LIBRARY.projects().values().stream()
                .flatMap(project -> project.plans().stream().map(plan -> Map.entry(project, plan)));
    }

    static Project panorama(String name) {
        String file = "/plans/panorama-" + name + ".json";
        try (InputStream in = TriedPlans.class.getResourceAsStream(file)) {
            return new ProjectReader(LIBRARY.vocabulary())
                    .read(new String(in.readAllBytes(), StandardCharsets.UTF_8))
                    .orThrow();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static List<String> robots(int count) {
        return IntStream.rangeClosed(1, count).mapToObj(i -> "robot-" + i).toList();
    }

    /** Runs a plan on by itself until nothing leads on. */
    static Stepper run(Project project, String plan, int robots, int locations) {
        Stepper stepper = Stepper.start(new Engine(LIBRARY.vocabulary(), project), plan, plan, robots(robots));
        for (int i = 0; i < MOST_STEPS && stepper.outcome().isEmpty(); i++) {
            Turns.Turn turn = Turns.next(stepper, List.of(locations), true, true);
            if (turn.step().isEmpty()) {
                return stepper;
            }
            stepper.take(turn.step().get().step());
        }
        return stepper;
    }
}
