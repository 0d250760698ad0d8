package org.sami.spn.engine;

import java.util.Optional;
import java.util.function.Function;
import org.sami.spn.engine.codec.LoadedProjects;
import org.sami.spn.engine.codec.StateDecoder;
import org.sami.spn.engine.codec.StateEncoder;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.rule.Rules;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.protocol.Input;

/**
 * The whole state of an engine as bytes, exact: what is decoded behaves in the same way for all further inputs. The
 * form is versioned and of the engine's own; plans are not in it: they are those of the engine that decodes, and of loaded
 * projects it names the documents by their SHA-256.
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
     * A state, of a session that loaded no project, from bytes.
     *
     * @throws IllegalArgumentException if they are no state, of another version, or speak of plans that the engine does not
     *     have
     */
    public static EngineState decode(byte[] bytes, Engine engine) {
        return decode(bytes, engine, sha256 -> Optional.empty());
    }

    /**
     * A state from bytes.
     *
     * @param documents gives the document of a loaded project by its SHA-256 ({@link Input.LoadProject#sha256()})
     * @throws IllegalArgumentException if they are no state, of another version, or speak of plans that neither the engine nor the
     *     documents have
     */
    public static EngineState decode(byte[] bytes, Engine engine, Function<String, Optional<String>> documents) {
        LoadedProjects loaded = (before, version, sha256) -> documents
                .apply(sha256)
                .flatMap(document ->
                        new ProjectReader(engine.vocabulary()).read(document).result())
                .map(project -> new CompiledProject(before, version, project, sha256))
                .orElseThrow(() -> new IllegalArgumentException(
                        "The state speaks of the loaded project " + sha256 + ", which is not there"));
        try {
            StateDecoder reader = new StateDecoder(bytes, engine.compiled());
            EngineState state = new EngineState(reader.read(loaded));
            if (reader.omitsUsedReturns()) {
                Rules rules = new Rules(state.net);
                rules.pendings.tellUnused();
                state.keep(rules);
            }
            return state;
        } catch (IllegalArgumentException e) {
            throw e;
        } catch (RuntimeException e) {
            throw new IllegalArgumentException("The bytes are no engine's state of these plans", e);
        }
    }
}
