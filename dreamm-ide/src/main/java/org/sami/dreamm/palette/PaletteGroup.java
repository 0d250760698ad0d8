package org.sami.dreamm.palette;

import java.util.List;
import java.util.Objects;

/**
 * A group of a palette.
 *
 * @param id stable, in kebab case; a profile can hide it
 * @param name for people
 */
record PaletteGroup(String id, String name, List<PaletteItem> items) {
    PaletteGroup {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        items = List.copyOf(items);
    }
}
