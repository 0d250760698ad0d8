package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

/** A state that was written and read behaves like the one it was, for whatever comes. */
class StateCodecTest {
    private static final Map<String, FieldSource> SECOND =
            Map.of("duration", new FieldSource.Fixed(new DurationValue(700)));

    private static final Plan CHILD = new NetBuilder("child")
            .start("c")
            .output("c", "Do")
            .output("c", "StartProxyTimer", SECOND, Map.of())
            .end("e")
            .output("e", "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue("r"))), Map.of())
            .transition("all", "Done")
            .waitForAll("all")
            .in("c", "all", "relevant all")
            .out("all", "e", "take all relevant")
            .transition("late", "ProxyTimerExpired", "News")
            .in("c", "late", "relevant all")
            .out("late", "d", "take all relevant")
            .output("d", "Choose")
            .transition("chosen", "Chosen")
            .in("d", "chosen", "relevant all")
            .out("chosen", "e", "take all relevant")
            .build();

    private static final Plan MAIN = new NetBuilder("main")
            .start("s")
            .variable("@n", ValueType.Simple.INTEGER, new IntegerValue(1))
            .task("T", "Measure", Map.of("point", GeoPoint.of(1, 2)))
            .output("s", "ChooseSome")
            .output(
                    "s",
                    "Approve",
                    new MarkupSpec(
                            "MixedInitiativeTrigger",
                            Map.of("trigger", new EnumValue("Trigger", "TIMER"), "timeout", new DurationValue(900))))
            .transition("go", "Chosen")
            .in("s", "go", "relevant all")
            .out("go", "work", "take all relevant")
            .transition("share", "Yes")
            .in("s", "share", "proxy >= 1")
            .out("share", "shared", "take 1 proxy", "take 1 task")
            .out("share", "s", "always")
            .sub("work", "child")
            .shared("shared", "child")
            .transition("back")
            .in("work", "back", "proxy >= 1")
            .out("back", "s", "take all sub")
            .transition("returned")
            .in("shared", "returned", "always")
            .out("returned", "s", "take all sub")
            .input("pull", "Interrupt", Map.of("interruptName", new TextValue("Pull")), Map.of())
            .in("work", "pull", "relevant >= 1")
            .out("pull", "s", "take all relevant")
            .input("note", "News", Map.of(), Map.of("value", "@n"))
            .in("s", "note", "relevant all")
            .in("work", "note", "proxy >= 2")
            .out("note", "x", "add all relevant")
            .build();

    private final Engine engine = new Engine(TestVocabulary.TEST, NetBuilder.project(MAIN, CHILD));

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
    void randomInputsHaveTheSameEffectsOnTheCopyAtEveryStep(int seed) {
        Random random = new Random(seed);
        EngineState original = engine.newState();
        EngineState followed = engine.newState();
        List<Effect> all = new ArrayList<>();
        long now = 0;
        int firings = 0;

        for (int i = 0; i < 300; i++) {
            now += random.nextInt(4) == 0 ? random.nextInt(400) : 0;
            Input input = i < 4 ? start(i) : random(random, original, all);
            byte[] bytes = StateCodec.encode(followed);
            followed = StateCodec.decode(bytes, engine);
            assertThat(StateCodec.encode(followed)).isEqualTo(bytes);

            List<Effect> effects = engine.step(original, now, input);
            List<Effect> again = engine.step(followed, now, input);

            assertThat(again).isEqualTo(effects);
            all.addAll(effects);
            firings += (int)
                    effects.stream().filter(Effect.Fired.class::isInstance).count();
        }
        assertThat(firings).isGreaterThan(20);
        assertThat(engine.view(followed).missions())
                .isEqualTo(engine.view(original).missions());
    }

    private static Input start(int i) {
        return i < 3
                ? new Input.ProxyJoined(List.of("A", "B", "C").get(i))
                : new Input.StartMission("main", "m", Map.of());
    }

    private Input random(Random random, EngineState state, List<Effect> effects) {
        EngineView view = engine.view(state);
        List<String> robots = new ArrayList<>(List.of("A", "B", "C", "D"));
        List<String> some = robots.subList(random.nextInt(3), 3 + random.nextInt(2));
        List<Activation> asked = effects.stream()
                .filter(Effect.Activated.class::isInstance)
                .map(e -> ((Effect.Activated) e).activation())
                .toList();
        return switch (random.nextInt(14)) {
            case 0, 1, 2, 3 -> decide(view, random);
            case 4, 5, 6, 7 -> answer(asked, some, random);
            case 8, 9 ->
                new Input.Received(Occurrence.news("News", some.subList(0, 1), Map.of("value", new IntegerValue(3))));
            case 10 -> new Input.Interrupt(0, "Pull", some.subList(0, 1));
            case 11 -> {
                long id = 1L + random.nextInt((int) Math.max(1, state.net.lastMission));
                yield random.nextBoolean() ? new Input.AbortMission(id) : new Input.CompleteMission(id);
            }
            case 12 ->
                random.nextInt(5) == 0
                        ? new Input.ProxyDropped("C", random.nextInt(2))
                        : new Input.ProxyJoined(robots.get(random.nextInt(4)));
            default -> new Input.AllocateTasks(Map.of(new TaskId(4, "T"), Optional.of("A")));
        };
    }

    private static Input decide(EngineView view, Random random) {
        if (view.decisions().isEmpty()) {
            return new Input.StartMission("main", "m", Map.of());
        }
        Decision d = view.decisions().get(random.nextInt(view.decisions().size()));
        return new Input.AnswerDecision(d.id(), answer(d, random), Answerer.OPERATOR);
    }

    private static Input answer(List<Activation> asked, List<String> some, Random random) {
        Activation a = asked.get(asked.size() - 1 - random.nextInt(Math.min(8, asked.size())));
        String type = List.of("Done", "News", "Done2").get(random.nextInt(3));
        List<String> named = a.proxies().isEmpty()
                ? some
                : List.of(a.proxies().get(random.nextInt(a.proxies().size())));
        return new Input.Received(Occurrence.answer(type, a, named, List.of(), Map.of()));
    }

    private static Answer answer(Decision d, Random random) {
        if (d.question() instanceof Question.ChooseProxies c && !c.proxies().isEmpty()) {
            return new Answer.Proxies(
                    c.proxies().subList(0, 1 + random.nextInt(c.proxies().size())));
        }
        return new Answer.YesNo(random.nextBoolean());
    }

    @Test
    void aCopyIsIndependent() {
        EngineState state = engine.newState();
        engine.step(state, 0, new Input.ProxyJoined("A"));
        engine.step(state, 0, new Input.StartMission("main", "m", Map.of()));
        byte[] before = StateCodec.encode(state);

        EngineState copy = state.copy();
        engine.step(copy, 5, new Input.AbortMission(0));

        assertThat(StateCodec.encode(state)).isEqualTo(before);
        assertThat(engine.view(copy).missions()).isEmpty();
    }

    @Test
    void everyKindOfValueIsKept() {
        EngineState state = engine.newState();
        List<Value> values = List.of(
                new IntegerValue(-3),
                new RealValue(0.1),
                new TextValue("grün"),
                new DurationValue(5),
                new EnumValue("Rank", "LOW"),
                new RecordValue("Choice", Map.of("text", new TextValue("t"))),
                new MapValue(Map.of(new ProxyValue("A"), new PlanReference("p"))),
                new TaskId(1, "T"),
                new GeoPath(List.of(GeoPoint.of(1, 2), new GeoPoint(3, 4, 5))),
                new GeoArea(
                        List.of(GeoPoint.of(0, 0), GeoPoint.of(0, 1), GeoPoint.of(1, 0)),
                        List.of(List.of(GeoPoint.of(0.1, 0.1)))),
                new VariableReference("@v"),
                new org.sami.spn.value.BooleanValue(true));
        engine.step(state, 0, new Input.StartMission("main", "m", Map.of()));

        engine.step(state, 0, new Input.Remember(1, "all", new ListValue(values)));

        EngineState decoded = StateCodec.decode(StateCodec.encode(state), engine);
        assertThat(engine.view(decoded).memory(1, "all")).contains(new ListValue(values));
    }

    @Test
    void whatIsRememberedForTheSessionOutlivesItsMissions() {
        EngineState state = engine.newState();
        engine.step(state, 0, new Input.StartMission("main", "m", Map.of()));
        engine.step(state, 0, new Input.Remember(Ids.NONE, "boot/A", new TextValue("b1")));
        engine.step(state, 0, new Input.AbortMission(1));

        EngineState decoded = StateCodec.decode(StateCodec.encode(state), engine);
        assertThat(engine.view(decoded).memory(Ids.NONE, "boot/A")).contains(new TextValue("b1"));
        assertThat(engine.view(decoded).memory(1, "boot/A")).isEmpty();
    }

    @Test
    void stateOfTheFirstVersionIsStillRead() {
        EngineState state = engine.newState();
        engine.step(state, 7, new Input.StartMission("main", "m", Map.of()));
        byte[] second = StateCodec.encode(state);
        int memoryAt = 4 + 4 + 8 * 8 + 4 + 4; // magic, version, counters; no robots, no globals
        byte[] first = new byte[second.length - 4];
        System.arraycopy(second, 0, first, 0, memoryAt);
        System.arraycopy(second, memoryAt + 4, first, memoryAt, first.length - memoryAt);
        first[7] = 1;

        EngineState decoded = StateCodec.decode(first, engine);
        int missions = engine.view(state).missions().size();
        int times = second.length - missions * 16; // when each started and how often it fired: not in the first version
        assertThat(Arrays.copyOf(StateCodec.encode(decoded), times)).isEqualTo(Arrays.copyOf(second, times));
        assertThat(engine.view(decoded).missions())
                .allMatch(mission -> mission.startedAtMillis().isEmpty());
    }

    @Test
    void aStateSaysWhenItsMissionsStartedAndHowOftenTheyFired() {
        EngineState state = engine.newState();
        engine.step(state, 7, new Input.StartMission("main", "m", Map.of()));

        MissionView mission = engine.view(StateCodec.decode(StateCodec.encode(state), engine))
                .missions()
                .get(0);

        assertThat(mission.startedAtMillis()).hasValue(7);
        assertThat(mission).isEqualTo(engine.view(state).missions().get(0));
    }

    @Test
    void bytesThatAreNoStateAreRefused() {
        EngineState state = engine.newState();
        engine.step(state, 0, new Input.StartMission("main", "m", Map.of()));
        byte[] bytes = StateCodec.encode(state);

        assertThatThrownBy(() -> StateCodec.decode(new byte[] {1, 2, 3, 4, 5}, engine))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> StateCodec.decode(Arrays.copyOf(bytes, bytes.length / 2), engine))
                .isInstanceOf(IllegalArgumentException.class);
        Engine other = new Engine(TestVocabulary.TEST, NetBuilder.project(CHILD));
        assertThatThrownBy(() -> StateCodec.decode(bytes, other)).isInstanceOf(IllegalArgumentException.class);
    }
}
