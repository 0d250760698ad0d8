package org.sami.crw.handler.activation;

import java.util.Optional;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.Value;

/** What the markups of an activation ask of services and boats (appendix .2.3); the last one of a kind counts. */
public final class Markups {
    private Markups() {}

    /** The criterion of the markup Optimize. */
    public static Optional<Criterion> criterion(Activation activation) {
        return option(activation, "Optimize", "criteria")
                .map(value -> Criterion.valueOf(((EnumValue) value).constant()));
    }

    /** How many options are asked for by the markup Selection Options; one without it, and one where it says less. */
    public static int requestedOptions(Activation activation) {
        long number = option(activation, "SelectionOptions", "number")
                .map(value -> ((IntegerValue) value).value())
                .orElse(1L);
        return (int) Math.max(1, Math.min(number, Integer.MAX_VALUE));
    }

    private static Optional<Value> option(Activation activation, String markup, String option) {
        return activation.markups().stream()
                .filter(spec -> spec.type().equals(markup))
                .reduce((first, second) -> second)
                .flatMap(spec -> spec.option(option));
    }
}
