package org.sami.spn.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.testing.TestVocabulary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ValueType;

/** Values that a copy of a state shares with its source: whichever is changed first, the other stays as it was. */
class CopiedValuesTest {
    private final Engine engine = new Engine(
            TestVocabulary.TEST,
            new Project(
                    "test",
                    "test",
                    "test",
                    List.of(new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(1)))),
                    List.of(),
                    List.of()));

    static List<Input> changes() {
        return List.of(
                new Input.SetVariable(Ids.NONE, "@global", new IntegerValue(2)),
                new Input.Remember(Ids.NONE, "key", new IntegerValue(3)),
                new Input.Received(new Occurrence("Pose", Ids.NONE, Ids.NONE, List.of("A"), List.of(), Map.of())));
    }

    @ParameterizedTest
    @MethodSource("changes")
    void aChangeOfTheSourceDoesNotReachItsCopy(Input change) {
        EngineState source = changedBefore();
        EngineState copy = source.copy();
        byte[] before = StateCodec.encode(copy);

        engine.step(source, 0, change);

        assertThat(StateCodec.encode(copy)).isEqualTo(before);
        assertThat(StateCodec.encode(source)).isNotEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("changes")
    void aChangeOfACopyReachesNeitherItsSourceNorAnotherCopy(Input change) {
        EngineState source = changedBefore();
        EngineState copy = source.copy();
        EngineState copyOfCopy = copy.copy();
        byte[] before = StateCodec.encode(source);

        engine.step(copy, 0, change);

        assertThat(StateCodec.encode(source)).isEqualTo(before);
        assertThat(StateCodec.encode(copyOfCopy)).isEqualTo(before);
        assertThat(StateCodec.encode(copy)).isNotEqualTo(before);
    }

    /** A state that has values of its own: each was changed since the state was made. */
    private EngineState changedBefore() {
        EngineState state = engine.newState();
        engine.step(state, 0, new Input.SetVariable(Ids.NONE, "@global", new IntegerValue(7)));
        engine.step(state, 0, new Input.Remember(Ids.NONE, "other", new IntegerValue(8)));
        changes().stream().skip(2).forEach(news -> engine.step(state, 0, news));
        return state;
    }
}
