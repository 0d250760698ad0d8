package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.HashMap;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** What a boat announces is read as it was written, and what is wrong is named. */
class BoatAnnouncementTest {
    private static final BoatAnnouncement ANNA = new BoatAnnouncement(
            "anna",
            "Anna die Älteste",
            "9f86d081884c7d65",
            BoatAnnouncement.Access.PAIRING,
            2,
            OptionalInt.of(87),
            "rudder");

    @Test
    void isReadAsItWasWritten() {
        assertThat(BoatAnnouncement.parse(ANNA.entries())).isEqualTo(ANNA);
        BoatAnnouncement plain = BoatAnnouncement.of("b", "", BoatAnnouncement.Access.OPEN, "");
        assertThat(BoatAnnouncement.parse(plain.entries())).isEqualTo(plain);
        assertThat(plain.entries()).doesNotContainKeys("battery", "key", "hull");
        assertThat(plain.sameLink()).isTrue();
    }

    @Test
    void unknownEntriesAreIgnoredAndTheNameMayBeMissing() {
        Map<String, String> entries = new HashMap<>(ANNA.entries());
        entries.put("colour", "red");
        entries.remove("name");

        assertThat(BoatAnnouncement.parse(entries).name()).isEqualTo("anna");
    }

    @Test
    void ofAnotherVersionIsReadAndToldApart() {
        assertThat(changed("link", "3").sameLink()).isFalse();
    }

    @Test
    void whatIsWrongIsNamed() {
        refused("id", "", "'id' is empty");
        refused("id", "an\u202ena", "'id' has control characters");
        refused("access", "all", "not 'all'");
        refused("link", "two", "'link' is no whole number");
        refused("link", "-1", "'link' is not in 0 to");
        refused("battery", "101", "'battery' is not in 0 to 100: 101");
        refused("hull", "x".repeat(300), "'hull' is too long");
        Map<String, String> entries = new HashMap<>(ANNA.entries());
        entries.remove("id");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BoatAnnouncement.parse(entries))
                .withMessageContaining("has no 'id'");
    }

    private static void refused(String key, String value, String why) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> changed(key, value))
                .withMessageContaining(why);
    }

    private static BoatAnnouncement changed(String key, String value) {
        Map<String, String> entries = new HashMap<>(ANNA.entries());
        entries.put(key, value);
        return BoatAnnouncement.parse(entries);
    }
}
