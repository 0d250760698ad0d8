package org.sami.ui.value;

import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.NamedType;

/**
 * What editors need of the world around them.
 *
 * @param declarations the named types of the vocabulary, by name
 * @param names what can be chosen by name
 * @param maps on which places are drawn
 */
public record ValueContext(Map<String, NamedType> declarations, NamedThings names, MapMaker maps) {
    public ValueContext {
        declarations = Map.copyOf(declarations);
        Objects.requireNonNull(names, "names");
        Objects.requireNonNull(maps, "maps");
    }
}
