package org.sami.ui.value;

import java.util.Objects;

/**
 * One option of a question, where it stands when it is shown.
 *
 * @param index of the option in the question, from 0; sorting and filtering leave it as it is
 * @param selected whether it is chosen when the question opens
 */
public record OfferedRow(int index, ChoiceRow row, boolean selected) {
    public OfferedRow {
        Objects.requireNonNull(row, "row");
    }
}
