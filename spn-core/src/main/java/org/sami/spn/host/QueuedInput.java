package org.sami.spn.host;

import org.sami.spn.protocol.Input;

/** An input on its way through the host, with the reply to whoever posted it. */
record QueuedInput(Input input, InputReply reply) {
    /** An input to which nobody waits for a reply. */
    static QueuedInput of(Input input) {
        return new QueuedInput(input, InputReply.NONE);
    }
}
