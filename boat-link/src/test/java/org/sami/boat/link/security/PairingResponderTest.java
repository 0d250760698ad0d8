package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Role;

/** Pairing: the words count once, for minutes, for few tries, and only for the two keys of one link. */
class PairingResponderTest {
    private final KeyRing boat = KeyRing.inMemory();
    private final PairingResponder responder = new PairingResponder(boat);
    private final Fingerprint base = Identity.generate().fingerprint();

    private String pair(PairingSecret words, long nowMs) throws IOException {
        String proof = words.proofOfBase(base, boat.identity().fingerprint());
        return responder.pair(base, "laptop", proof, nowMs);
    }

    @Test
    void baseThatKnowsTheWordsIsKeptAndTheBoatProvesThatItKnowsThemToo() throws IOException {
        PairingSecret words = responder.open(Role.COMMANDER, 0);

        String proof = pair(
                PairingSecret.parse(words.toString().toUpperCase(Locale.ROOT).replace(' ', '-')), 1000);

        assertThat(proof).isEqualTo(words.proofOfBoat(base, boat.identity().fingerprint()));
        assertThat(boat.find(base)).map(Peer::role).contains(Role.COMMANDER);
    }

    @Test
    void wordsCountOnceAndForMinutesOnly() throws IOException {
        PairingSecret words = responder.open(Role.COMMANDER, 0);
        pair(words, 0);
        assertThatThrownBy(() -> pair(words, 1)).hasMessageContaining("the words have been used");

        PairingSecret later = responder.open(Role.COMMANDER, 10);
        assertThat(responder.isOpen(PairingResponder.OPEN_MS + 9)).isTrue();
        assertThatThrownBy(() -> pair(later, PairingResponder.OPEN_MS + 10)).hasMessageContaining("count no longer");
        assertThatThrownBy(() -> pair(later, 11)).hasMessageContaining("count no longer");
    }

    @Test
    void fiveWrongProofsCloseThePairing() {
        PairingSecret words = responder.open(Role.COMMANDER, 0);
        for (int left = 4; left >= 0; left--) {
            String tries = left + (left == 1 ? " try" : " tries");
            assertThatThrownBy(() -> pair(PairingSecret.random(), 0)).hasMessageContaining(tries);
        }

        assertThatThrownBy(() -> pair(words, 0)).hasMessageContaining("5 wrong words");
        assertThat(boat.peers()).isEmpty();
    }

    @Test
    void proofThatSomebodyInBetweenPassesOnIsWrong() {
        PairingSecret words = responder.open(Role.COMMANDER, 0);
        Fingerprint between = Identity.generate().fingerprint();
        String proofToBetween = words.proofOfBase(base, between);

        assertThatThrownBy(() -> responder.pair(between, "laptop", proofToBetween, 0))
                .hasMessageContaining("in between");
        assertThat(PairingSecret.checkCode(base, between))
                .isNotEqualTo(PairingSecret.checkCode(between, boat.identity().fingerprint()));
    }

    @Test
    void proofOfTheBoatIsNoProofOfABase() {
        PairingSecret words = responder.open(Role.COMMANDER, 0);
        Fingerprint own = boat.identity().fingerprint();

        assertThatThrownBy(() -> responder.pair(base, "laptop", words.proofOfBoat(base, own), 0))
                .isInstanceOf(LinkRefusedException.class);
    }

    @Test
    void noTwoWordsBeginWithTheSameFourLettersAndFourLettersAreEnough() {
        Set<String> beginnings = new HashSet<>();
        for (int i = 0; i < PairingWordList.size(); i++) {
            String word = PairingWordList.word(i);
            assertThat(word).matches("[a-z]{4,8}");
            assertThat(beginnings.add(word.substring(0, 4))).as(word).isTrue();
            assertThat(PairingWordList.find(word.substring(0, 4))).isEqualTo(word);
        }

        assertThat(beginnings).hasSize(1024);
    }

    @Test
    void wrongWordIsNamedAndMissingOnesAreCounted() {
        assertThatThrownBy(() -> PairingSecret.parse("able about xyzzy acts adds after"))
                .hasMessage("'xyzzy' is none of the words that a boat shows");
        assertThatThrownBy(() -> PairingSecret.parse("able about")).hasMessage("six words are needed, not 2");
        assertThatThrownBy(() -> PairingSecret.parse(" ")).hasMessage("six words are needed, not 0");
    }
}
