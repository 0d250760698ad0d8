package org.sami.ui.value;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * What a component is to be made for.
 *
 * @param field the value, with the type that the component was chosen for
 * @param widgets names of the widgets to put on it
 * @param offer what is to be chosen from; empty where a value is given or shown
 */
record ComponentRequest(ValueField field, List<String> widgets, Optional<Offer> offer) {
    ComponentRequest {
        Objects.requireNonNull(field, "field");
        widgets = List.copyOf(widgets);
        Objects.requireNonNull(offer, "offer");
    }

    boolean wants(String widget) {
        return widgets.contains(widget);
    }
}
