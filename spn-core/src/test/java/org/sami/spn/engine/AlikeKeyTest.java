package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Input;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.Session;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;

/** States that differ only in who is who, in orders that no rule reads, in points and in the length of timers have one key; others have not. */
class AlikeKeyTest {
    private static final Set<String> ROBOTS = Set.of("A", "B");

    private static NetBuilder net() {
        return new NetBuilder("main")
                .start("s")
                .output("s", "GenerateTasks", Map.of("locations", fixed(2)), Map.of())
                .transition("made", "TasksGenerated")
                .in("s", "made", "generic >= 1")
                .out("made", "tasks", "add all relevant")
                .transition("toLeft", "Pose")
                .in("s", "toLeft", "relevant all")
                .out("toLeft", "left", "take all relevant")
                .transition("toRight", "News")
                .in("s", "toRight", "relevant all")
                .out("toRight", "right", "take all relevant")
                .output(
                        "right",
                        "StartProxyTimer",
                        Map.of("duration", new FieldSource.Fixed(new DurationValue(5000))),
                        Map.of());
    }

    private static FieldSource fixed(int points) {
        return new FieldSource.Fixed(new ListValue(java.util.stream.IntStream.range(0, points)
                .mapToObj(i -> (org.sami.spn.value.Value) GeoPoint.of(1, i))
                .toList()));
    }

    private static AlikeKeyBytes key(Plan plan, Consumer<Session> run) {
        Session s = new Session(plan);
        s.join("A", "B").start("main");
        run.accept(s);
        return new AlikeKeyBytes(
                new String(AlikeKey.of(s.state(), ROBOTS).bytes(), java.nio.charset.StandardCharsets.UTF_8));
    }

    private record AlikeKeyBytes(String text) {}

    private static Input allocation(String first, String second) {
        return new Input.AllocateTasks(
                Map.of(new TaskId(1, "Task 1"), Optional.of(first), new TaskId(1, "Task 2"), Optional.of(second)));
    }

    @Test
    void exchangeOfTwoRobotsIsNoOtherState() {
        Plan plan = net().build();

        assertThat(key(plan, s -> s.news("Pose", "A"))).isEqualTo(key(plan, s -> s.news("Pose", "B")));
        assertThat(key(plan, s -> s.news("Pose", "A"))).isNotEqualTo(key(plan, s -> s.news("News", "A")));
        assertThat(key(plan, s -> s.news("Pose", "A"))).isNotEqualTo(key(plan, s -> {
            s.news("Pose", "A");
            s.news("Pose", "B");
        }));
    }

    @Test
    void whoHasHowManyTasksIsPartOfTheState() {
        Plan plan = net().build();

        assertThat(key(plan, s -> s.step(allocation("A", "B"))))
                .isEqualTo(key(plan, s -> s.step(allocation("B", "A"))));
        assertThat(key(plan, s -> s.step(allocation("A", "A"))))
                .isEqualTo(key(plan, s -> s.step(allocation("B", "B"))));
        assertThat(key(plan, s -> s.step(allocation("A", "A"))))
                .isNotEqualTo(key(plan, s -> s.step(allocation("A", "B"))));
    }

    @Test
    void robotThatStandsElsewhereWithItsTasksIsAnotherState() {
        Plan plan = net().build();
        Consumer<Session> here = s -> {
            s.step(allocation("A", "A"));
            s.news("Pose", "A");
        };
        Consumer<Session> other = s -> {
            s.step(allocation("A", "A"));
            s.news("Pose", "B");
        };

        assertThat(key(plan, here)).isNotEqualTo(key(plan, other));
    }

    @Test
    void orderOfEntryCountsWhereSomeAreTaken() {
        Consumer<Session> one = s -> {
            s.step(allocation("A", "A"));
            s.news("Pose", "A");
            s.news("Pose", "B");
        };
        Consumer<Session> other = s -> {
            s.step(allocation("A", "A"));
            s.news("Pose", "B");
            s.news("Pose", "A");
        };
        Plan all = net().build();
        Plan some = net().transition("one", "Other")
                .in("left", "one", "proxy >= 1")
                .out("one", "gone", "take 1 proxy")
                .build();

        assertThat(key(all, one)).isEqualTo(key(all, other));
        assertThat(key(some, one))
                .as("the oldest is the one with tasks, or not")
                .isNotEqualTo(key(some, other));
    }

    @Test
    void timersCountByTheOrderInWhichTheyRunDown() {
        Plan plan = net().build();
        Consumer<Session> after1 = s -> {
            s.news("News", "A");
            s.advance(1000);
            s.news("News", "B");
        };
        Consumer<Session> after3 = s -> {
            s.news("News", "A");
            s.advance(3000);
            s.news("News", "B");
        };
        Consumer<Session> atOnce = s -> {
            s.news("News", "A");
            s.news("News", "B");
        };

        assertThat(key(plan, after1)).isEqualTo(key(plan, after3)).isNotEqualTo(key(plan, atOnce));
    }

    @Test
    void robotsThatAreNotAlikeKeepTheirNames() {
        Session one = new Session(net().build());
        one.join("A", "B").start("main");
        one.news("Pose", "A");
        Session other = new Session(net().build());
        other.join("A", "B").start("main");
        other.news("Pose", "B");

        assertThat(AlikeKey.of(one.state(), Set.of()).bytes())
                .isNotEqualTo(AlikeKey.of(other.state(), Set.of()).bytes());
    }
}
