package org.sami.spn.host;

/** The state of a host's engine between two batches, encoded by {@code StateCodec}. Immutable. */
public final class HostState {
    private final long index;
    private final byte[] state;

    /**
     * A state.
     *
     * @param index index in the journal of the last input in it; 0 for none
     * @param state encoded
     */
    public HostState(long index, byte[] state) {
        this.index = index;
        this.state = state.clone();
    }

    /** Index in the journal of the last input in it; 0 for none. */
    public long index() {
        return index;
    }

    /** A copy of the encoded state. */
    public byte[] state() {
        return state.clone();
    }
}
