package org.sami.dreamm.learn.show;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.LayoutPoint;

/** Where the pointer goes before an edit is made. */
public sealed interface ShowStop {
    /** An item of the palette. */
    record Item(String id) implements ShowStop {
        public Item {
            Objects.requireNonNull(id, "id");
        }
    }

    /** An element of the net that is open: a vertex or an edge. */
    record Element(String id) implements ShowStop {
        public Element {
            Objects.requireNonNull(id, "id");
        }
    }

    /** A point of the net, in units of the plan's layout. */
    record Spot(LayoutPoint at) implements ShowStop {
        public Spot {
            Objects.requireNonNull(at, "at");
        }
    }

    /**
     * A part of the inspector.
     *
     * @param selected ids of what is selected while it is shown; none shows the plan
     * @param within the name of the part in which it lies; empty text for the inspector
     * @param name of the component
     */
    record Editor(List<String> selected, String within, String name) implements ShowStop {
        public Editor {
            selected = List.copyOf(selected);
            Objects.requireNonNull(within, "within");
            Objects.requireNonNull(name, "name");
        }
    }
}
