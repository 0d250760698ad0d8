package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * Says where an imported project came from, and what of it arrived otherwise than it stood there. Kept with the project, so that
 * a check can tell what the import changed from what its authors drew.
 *
 * @param file name of the file, without its folder
 * @param remarks in the order of that file
 */
public record ImportOrigin(String file, List<Remark> remarks) {
    public ImportOrigin {
        Objects.requireNonNull(file, "file");
        remarks = List.copyOf(remarks);
    }

    /**
     * One thing that arrived otherwise, or not at all.
     *
     * @param code stable, of the import's findings (docs/import-legacy.md)
     * @param plan id of the plan here; empty text where it concerns the whole project
     * @param elements ids of vertices and edges of the plan
     */
    public record Remark(String code, String plan, List<String> elements, String message) {
        public Remark {
            Objects.requireNonNull(code, "code");
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(message, "message");
            elements = List.copyOf(elements);
        }
    }
}
