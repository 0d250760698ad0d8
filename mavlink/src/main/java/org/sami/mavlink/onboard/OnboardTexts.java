package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.Statustext;
import java.util.ArrayList;
import java.util.List;
import org.sami.mavlink.vehicle.TextSeverity;

/** Writes texts for the people at ground stations (STATUSTEXT), long ones in parts. For one thread. */
final class OnboardTexts {
    private static final int PART = 50;
    private static final int LONGEST = 250;
    private static final int IDS = 65_535;

    private int lastId;

    List<Object> messages(TextSeverity severity, String text) {
        String plain = text.replaceAll("[^ -~]", "?");
        String whole = plain.length() <= LONGEST ? plain : plain.substring(0, LONGEST - 3) + "...";
        MavSeverity degree = MavSeverity.valueOf("MAV_SEVERITY_" + severity.name());
        if (whole.length() <= PART) {
            return List.of(Statustext.builder().severity(degree).text(whole).build());
        }
        lastId = lastId % IDS + 1;
        List<Object> parts = new ArrayList<>();
        for (int from = 0; from <= whole.length(); from += PART) { // a last part that is empty ends a full one
            parts.add(Statustext.builder()
                    .severity(degree)
                    .text(whole.substring(from, Math.min(whole.length(), from + PART)))
                    .id(lastId)
                    .chunkSeq(parts.size())
                    .build());
        }
        return parts;
    }
}
