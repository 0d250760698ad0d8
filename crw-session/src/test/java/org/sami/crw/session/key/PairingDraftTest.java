package org.sami.crw.session.key;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.crw.session.key.PairingDraft.State;

/** What is typed in order to pair a boat is judged while it is typed. */
class PairingDraftTest {
    private static final String AT = "10.0.0.7:5001";
    private static final String WORDS = "able about above absent absolute accepted";

    private static PairingDraft said(String text) {
        return new PairingDraft(AT, text);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "''|UNFINISHED|Type the six words",
                "ab|UNFINISHED|1 of six words",
                "able|UNFINISHED|1 of six words",
                "able abou|UNFINISHED|2 of six words",
                "xyz|WRONG|'xyz' is none of the words",
                "able xq|WRONG|'xq' is none of the words",
                "ab able|WRONG|'ab' is none of the words",
                "able about above absent absolute accepted|COMPLETE|Six words; the boat is at 10.0.0.7:5001",
                "able.abou.abov.abse.abso.acce|COMPLETE|Six words",
                "able about above absent absolute accepted able|WRONG|six words, not 7",
                "SAMI1;nothing|WRONG|the pairing code is damaged",
                "SAMI7;nothing|WRONG|of version 7"
            })
    void judgesWordsAndCodes(String text, State state, String words) {
        PairingDraft.Judgement judged = said(text).judge();

        assertThat(judged.words()).contains(words);
        assertThat(judged.state()).isEqualTo(state);
    }

    @Test
    void addressIsAskedForUnlessTheCodeSaysIt() {
        KeyRing boat = KeyRing.inMemory();
        PairingCode code = new PairingCode(AT, "anna", boat.identity().fingerprint(), PairingSecret.parse(WORDS));

        assertThat(new PairingDraft("", WORDS).judge().words()).contains("the address of the boat's server is needed");
        assertThat(new PairingDraft("", WORDS).judge().state()).isEqualTo(State.UNFINISHED);
        assertThat(new PairingDraft("10.0.0.7", WORDS).judge().state()).isEqualTo(State.WRONG);
        assertThat(new PairingDraft("", code.toString()).judge())
                .isEqualTo(new PairingDraft.Judgement(State.COMPLETE, "The QR code is of anna, at " + AT));
        assertThat(new PairingDraft("10.0.0.8:1", code.toString()).judge().words())
                .contains("10.0.0.8:1");
    }

    @Test
    void lastWordIsCompletedFromTheList() {
        assertThat(said("able ab").completions()).startsWith("able", "about", "above");
        assertThat(said("able abso").completed()).isEqualTo("able absolute ");
        assertThat(said("able absolute").completions()).isEmpty();
        assertThat(said("able ").completed()).isEqualTo("able ");
        assertThat(said("SAMI1;ab").completions()).isEmpty();
    }
}
