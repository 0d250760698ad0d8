package org.sami.crw.task;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/** The queues of several boats on a real engine, also one that goes on with a state of a process that died. */
class TaskQueuesTest {
    private static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final TaskId A = new TaskId(1, "a");
    private static final TaskId B = new TaskId(1, "b");
    private static final TaskId OTHER = new TaskId(2, "a");

    /** Two tasks that stand where their mission starts, and nothing else. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p",
              "tasks": [{"name": "a", "class": "Temperature"}, {"name": "b", "class": "Temperature"}],
              "places": [{"id": "start", "start": true}, {"id": "end", "end": true}],
              "transitions": [{"id": "t", "inputs": [{"id": "i", "type": "OperatorInterruptReceived",
                "fields": {"interruptName": "End"}}]}],
              "inEdges": [{"id": "e", "place": "start", "transition": "t",
                "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
              "outEdges": [{"id": "o", "transition": "t", "place": "end",
                "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]}]}
            """;

    private final Project project = new ProjectReader(VOCABULARY).read(PLAN).orThrow();
    private final Engine engine = new Engine(VOCABULARY, project);
    private EngineState state = engine.newState();
    private final ArrayDeque<Runnable> work = new ArrayDeque<>();
    private final List<String> news = new ArrayList<>();
    private boolean failing;
    private EngineHost host;
    private TaskQueues queues;

    @Test
    void theFirstTaskOfABoatIsStartedAndTheNextWhenTheFirstIsGone() {
        begin(true);
        post(allocate(A, "east", B, "east"));
        assertThat(news).containsExactly("STARTED a of 1 east");

        post(allocate(A, "west"));

        assertThat(news.subList(1, news.size()))
                .containsExactly(
                        "RELEASED a of 1 east", "REASSIGNED a of 1 west", "STARTED b of 1 east", "STARTED a of 1 west");
    }

    @Test
    void aListenerThatThrowsLosesNoNews() {
        begin(true);
        failing = true;

        post(allocate(A, "east", B, "east"));

        assertThat(host.<Object>ask(view -> view.memory(Ids.NONE, "tasks/east").orElseThrow()))
                .as("what the journal knows")
                .isEqualTo(queues.of("east").toValue());
        assertThat(queues.of("east").tasks()).containsExactly(A, B);
    }

    @Test
    void aMissionThatEndsMakesRoomForTheTasksOfAnother() {
        begin(true);
        post(allocate(A, "east"));
        post(allocate(OTHER, "east"));
        assertThat(queues.of("east").tasks()).containsExactly(A, OTHER);

        post(new Input.AbortMission(1));

        assertThat(queues.of("east").tasks()).containsExactly(OTHER);
        assertThat(news).endsWith("STARTED a of 2 east");
    }

    @Test
    void aBoatThatIsDroppedLosesAllItsTasks() {
        begin(true);
        post(allocate(A, "east", B, "east"));

        post(new Input.ProxyDropped("east", Ids.NONE));

        assertThat(queues.of("east").tasks()).isEmpty();
        assertThat(news.subList(1, news.size()))
                .containsExactly(
                        "RELEASED a of 1 east", "RELEASED b of 1 east", "UNASSIGNED a of 1 ", "UNASSIGNED b of 1 ");
    }

    @Test
    void whatWasAllocatedJustBeforeTheProcessDiedIsToldOnceAfterwards() {
        begin(true);
        post(allocate(A, "east"));
        engine.step(state, 0, allocate(A, "west", B, "east")); // journalled, and nobody lived to hear of it
        news.clear();

        begin(false);
        post(new Input.TimeReached());
        post(new Input.TimeReached());

        assertThat(news)
                .containsExactly(
                        "RELEASED a of 1 east", "REASSIGNED a of 1 west", "STARTED b of 1 east", "STARTED a of 1 west");
        assertThat(queues.of("west").tasks()).containsExactly(A);
    }

    @Test
    void theOrderOfAQueueOutlivesTheProcess() {
        begin(true);
        post(allocate(B, "east", A, "east"));
        news.clear();

        begin(false);
        post(new Input.TimeReached());

        assertThat(queues.of("east").tasks()).containsExactly(B, A);
        assertThat(news).isEmpty();
    }

    private void begin(boolean fresh) {
        if (!fresh) {
            state = state.copy();
        }
        host = EngineHostBuilder.of(engine, state)
                .clock(new Standing())
                .executor(work::add)
                .build();
        queues = new TaskQueues(host, (one, names) -> {
            if (failing) {
                throw new IllegalStateException("a listener that fails");
            }
            news.add(one.kind() + " " + one.task().name() + " of " + one.task().mission() + " " + one.boat());
        });
        host.addListener(queues);
        host.resume();
        if (fresh) {
            post(new Input.ProxyJoined("east"));
            post(new Input.ProxyJoined("west"));
            post(new Input.StartMission("p", "one", Map.of()));
            post(new Input.StartMission("p", "two", Map.of()));
        }
    }

    private void post(Input input) {
        host.post(input);
        for (Runnable next = work.poll(); next != null; next = work.poll()) {
            next.run();
        }
    }

    private static Input allocate(Object... pairs) {
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        for (int i = 0; i < pairs.length; i += 2) {
            allocation.put((TaskId) pairs[i], Optional.of((String) pairs[i + 1]));
        }
        return new Input.AllocateTasks(allocation);
    }

    /** Time stands still. */
    private static final class Standing implements HostClock {
        @Override
        public long nowMillis() {
            return 0;
        }

        @Override
        public void wakeAt(long millis, Runnable action) {
            // no plan of this test has timers
        }
    }
}
