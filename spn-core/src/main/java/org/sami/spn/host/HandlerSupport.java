package org.sami.spn.host;

import java.util.List;
import java.util.function.Function;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Input;

/** What handlers need of the host that calls them. */
interface HandlerSupport {
    /** Takes in inputs as one batch; false if the host has stopped. */
    boolean post(List<Input> inputs);

    /** Asks about the state and waits for the answer. */
    <T> T ask(Function<EngineView, T> question);

    /** The session's time. */
    long nowMillis();
}
