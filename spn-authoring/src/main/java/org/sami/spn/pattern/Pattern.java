package org.sami.spn.pattern;

import java.util.Optional;
import org.sami.spn.edit.Edit;

/** A way in which plans are often drawn. */
public interface Pattern {
    /** Stable, in kebab case; a profile can hide its command {@code pattern-} and this id. */
    String id();

    /** A few words for people. */
    String title();

    /** A sentence or two on what to select and what is drawn. */
    String help();

    /** Why it cannot stand at a selection, in one sentence; empty where it can. */
    Optional<String> refusal(PatternSpot spot);

    /** The edit that draws it; asked only where nothing refuses it. */
    Edit edit(PatternSpot spot);
}
