package org.sami.spn.vocabulary;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * How an output event becomes a decision of the operator, and which input event its answer becomes.
 *
 * @param accepted the input event for yes, the choice or the given values
 * @param rejected the input event for no or "none of them"; empty text where the form has no such answer
 * @param min least number to choose (CHOOSE_PROXIES)
 * @param max greatest number to choose; {@link Integer#MAX_VALUE} for any
 * @param optionsField field of the output event that holds the list of options (CHOOSE_OPTION), else empty text
 * @param answerFields fields of the accepted event from the chosen option: {@code "."} is the option itself,
 *     {@code "x"} its record field x (CHOOSE_OPTION)
 */
public record DecisionType(
        DecisionForm form,
        String accepted,
        String rejected,
        int min,
        int max,
        String optionsField,
        Map<String, String> answerFields,
        AnswerNames names,
        AutonomyAnswer autonomy) {
    public DecisionType {
        Objects.requireNonNull(form, "form");
        Objects.requireNonNull(accepted, "accepted");
        Objects.requireNonNull(rejected, "rejected");
        Objects.requireNonNull(optionsField, "optionsField");
        answerFields = Collections.unmodifiableMap(new LinkedHashMap<>(answerFields));
        Objects.requireNonNull(names, "names");
        Objects.requireNonNull(autonomy, "autonomy");
        if (min < 0 || max < min) {
            throw new IllegalArgumentException("Not a range of choices: " + min + " to " + max);
        }
    }
}
