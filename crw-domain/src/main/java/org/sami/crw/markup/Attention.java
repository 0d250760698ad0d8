package org.sami.crw.markup;

import java.util.Objects;
import java.util.Optional;

/**
 * How the operator's attention is drawn to an interaction (markup Attention).
 *
 * @param type how
 * @param end until when
 * @param target to what
 */
public record Attention(Type type, End end, Target target) {
    private static final String MARKUP = "Attention";

    /** How attention is drawn. */
    public enum Type {
        HIGHLIGHT,
        BLINK
    }

    /** Until when attention is drawn. */
    public enum End {
        /** Until the operator has clicked on the interaction. */
        ON_CLICK
    }

    /** To what attention is drawn. */
    public enum Target {
        /** The component that shows the interaction. */
        COMPONENT,
        /** All boats on the map. */
        ALL_PROXIES,
        /** The boats that the interaction is about, on the map. */
        RELEVANT_PROXIES
    }

    public Attention {
        Objects.requireNonNull(type, "type");
        Objects.requireNonNull(end, "end");
        Objects.requireNonNull(target, "target");
    }

    /** What the markup of an interaction says; empty where it has none. */
    public static Optional<Attention> of(MarkupReader markups) {
        return markups.markup(MARKUP)
                .map(spec -> new Attention(
                        markups.constant(MARKUP, "type", Type.class).orElse(Type.HIGHLIGHT),
                        markups.constant(MARKUP, "end", End.class).orElse(End.ON_CLICK),
                        markups.constant(MARKUP, "target", Target.class).orElse(Target.COMPONENT)));
    }
}
