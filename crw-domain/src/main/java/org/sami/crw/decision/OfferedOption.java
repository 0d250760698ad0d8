package org.sami.crw.decision;

import java.util.Objects;
import org.sami.spn.value.Value;

/**
 * One option of a decision.
 *
 * @param index its place in the decision's own list, from 0, by which {@code Answer.Option} names it
 * @param value a boat as a {@code ProxyValue}, any other option as it was offered
 * @param label a few words that name it
 * @param detail more about it, such as the boat's description by plans; may be empty text
 * @param selected whether it is selected when the decision opens (markup Default Selection)
 */
public record OfferedOption(int index, Value value, String label, String detail, boolean selected) {
    public OfferedOption {
        Objects.requireNonNull(value, "value");
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(detail, "detail");
    }
}
