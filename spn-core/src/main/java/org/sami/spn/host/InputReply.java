package org.sami.spn.host;

import java.util.List;
import org.sami.spn.protocol.Effect;

/** Receives what followed from one input that its owner has posted. */
@FunctionalInterface
public interface InputReply {
    /** For inputs whose poster does not wait for anything. */
    InputReply NONE = effects -> {};

    /**
     * The input was processed and is durable. Called once, on the engine's thread, before the listeners hear of the step; must be quick. What it throws is
     * logged and reaches nobody else. Not called for an input that is never processed: then the host has stopped, or stops without having processed it
     * ({@link HostListener#onFailed}).
     */
    void onProcessed(List<Effect> effects);
}
