package org.sami.crw.message;

/** Where messages for the operator go. May be called from any thread. */
@FunctionalInterface
public interface MessageSink {
    /** Tells the operator; does not wait. */
    void tell(OperatorMessage message);
}
