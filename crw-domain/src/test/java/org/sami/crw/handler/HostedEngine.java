package org.sami.crw.handler;

import java.util.function.Consumer;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.StateCodec;
import org.sami.spn.host.EngineFunction;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/** The engine with a state of its own. */
final class HostedEngine implements EngineFunction {
    private final Engine engine;
    private final EngineState state;

    HostedEngine(Project project) {
        engine = new Engine(TestWorld.VOCABULARY, project);
        state = engine.newState();
    }

    @Override
    public void step(long nowMillis, Input input, Consumer<? super Effect> effects) {
        engine.step(state, nowMillis, input, effects);
    }

    @Override
    public EngineView view() {
        return engine.view(state);
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
