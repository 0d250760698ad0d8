package org.sami.spn.host;

import java.util.function.Consumer;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * An engine together with the state that it changes, as a host sees it; {@code EngineHostBuilder.of(engine, state)} makes one.
 * Used by one thread at a time.
 */
public interface EngineFunction {
    /** Takes one input at a time and gives what follows, in order. */
    void step(long nowMillis, Input input, Consumer<? super Effect> effects);

    /** Questions about the state. */
    EngineView view();

    /** The whole state as bytes. */
    byte[] encode();

    /** The words that its plans use. */
    Vocabulary vocabulary();
}
