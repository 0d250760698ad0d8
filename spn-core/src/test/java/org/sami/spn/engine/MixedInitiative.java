package org.sami.spn.engine;

import java.util.Map;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;

/** MixedInitiative that tests of decisions share. */
final class MixedInitiative {
    private MixedInitiative() {}

    /** Has autonomy answer at once, or after so many milliseconds. */
    static MarkupSpec trigger(String when, long millis) {
        return new MarkupSpec(
                "MixedInitiativeTrigger",
                Map.of("trigger", new EnumValue("Trigger", when), "timeout", new DurationValue(millis)));
    }
}
