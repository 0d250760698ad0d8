package org.sami.spn.host;

import java.util.Objects;
import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/** The engine of the language with one of its states. */
final class EngineWithState implements EngineFunction {
    private final Engine engine;
    private final EngineState state;
    private final EngineView view;

    EngineWithState(Engine engine, EngineState state) {
        this.engine = Objects.requireNonNull(engine, "engine");
        this.state = Objects.requireNonNull(state, "state");
        this.view = engine.view(state);
    }

    @Override
    public void step(long nowMillis, Input input, Consumer<? super Effect> effects) {
        engine.step(state, nowMillis, input, effects);
    }

    @Override
    public EngineView view() {
        return view;
    }

    @Override
    public byte[] encode() {
        return StateCodec.encode(state);
    }

    @Override
    public Vocabulary vocabulary() {
        return engine.vocabulary();
    }
}
