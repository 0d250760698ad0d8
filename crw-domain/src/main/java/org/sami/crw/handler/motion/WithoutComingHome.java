package org.sami.crw.handler.motion;

import java.util.Optional;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.BooleanValue;

/**
 * News that a boat goes on with a critical battery because the operator chose so, or does so no longer, as the engine's journalled memory has it.
 *
 * @param goes whether it goes on
 */
public record WithoutComingHome(String boat, boolean goes) {
    static final String KEY = "without-coming-home/";

    /** What an input says of it. */
    public static Optional<WithoutComingHome> of(Input input) {
        return input instanceof Input.Remember remembered
                        && remembered.key().startsWith(KEY)
                        && remembered.value() instanceof BooleanValue goes
                ? Optional.of(new WithoutComingHome(remembered.key().substring(KEY.length()), goes.value()))
                : Optional.empty();
    }
}
