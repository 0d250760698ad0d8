package org.sami.spn.protocol;

import java.util.Objects;
import org.sami.spn.value.TaskId;

/**
 * A token (thesis 3.1, Tokens). Equal tokens are copies of each other.
 *
 * <p>Implements R-TOK-1.
 */
public sealed interface Token {
    /** The generic token. */
    Token GENERIC = new Generic();

    /** Counted, without identity. */
    record Generic() implements Token {}

    /** One robot. */
    record Proxy(String proxy) implements Token {
        public Proxy {
            Objects.requireNonNull(proxy, "proxy");
        }
    }

    /** One task; the proxy to which it is allocated is state of the engine, not part of its identity. */
    record Task(TaskId task) implements Token {
        public Task {
            Objects.requireNonNull(task, "task");
        }
    }
}
