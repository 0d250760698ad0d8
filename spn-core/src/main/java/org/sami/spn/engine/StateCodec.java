package org.sami.spn.engine;

import org.sami.spn.engine.codec.StateDecoder;
import org.sami.spn.engine.codec.StateEncoder;

/**
 * The whole state of an engine as bytes, exact: what is decoded behaves in the same way for all further inputs. The
 * form is versioned and of the engine's own; plans are not in it, they are those of the engine that decodes.
 *
 * <p>Implements R-DET-4.
 */
public final class StateCodec {
    private StateCodec() {}

    /** A state as bytes; between two steps only. */
    public static byte[] encode(EngineState state) {
        return new StateEncoder().write(state.net);
    }

    /**
     * A state from bytes.
     *
     * @throws IllegalArgumentException if they are no state, of another version, or speak of plans that the engine does not
     *     have
     */
    public static EngineState decode(byte[] bytes, Engine engine) {
        try {
            StateDecoder reader = new StateDecoder(bytes);
            EngineState state = new EngineState(reader.read(engine.compiled()));
            if (reader.leavesReturnsUntold()) {
                state.rules().pendings.tellUnused();
            }
            return state;
        } catch (IllegalArgumentException e) {
            throw e;
        } catch (RuntimeException e) {
            throw new IllegalArgumentException("The bytes are no engine's state of these plans", e);
        }
    }
}
