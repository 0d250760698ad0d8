package org.sami.boat.link.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

/** The text of a QR code: what a boat writes a base reads, and what is none or damaged is named. */
class PairingCodeTest {
    private static final PairingSecret WORDS = PairingSecret.parse("able about above absent absolute accepted");
    private static final Fingerprint KEY =
            Fingerprint.parse("9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08");

    private static String text(String address, String name) {
        return new PairingCode(address, name, KEY, WORDS).toString();
    }

    @Test
    void isTheLineOfTheDocumentation() {
        assertThat(text("192.168.43.7:5001", "anna"))
                .isEqualTo("SAMI1;192.168.43.7:5001;n4bQgYhMfWWaL-qgxVrQFaO_TxsrC4Is0V1sFbDwCgg;"
                        + "able.abou.abov.abse.abso.acce;anna");
    }

    @Test
    void saysAllThatTheBoatHasPutIn() {
        PairingCode read = PairingCode.parse(text("[fe80::1%wlan0]:5001", "Überläufer & Söhne; 3"));

        assertThat(read.address()).isEqualTo("[fe80::1%wlan0]:5001");
        assertThat(read.boatName()).isEqualTo("Überläufer & Söhne; 3");
        assertThat(read.key()).isEqualTo(KEY);
        assertThat(read.words()).isEqualTo(WORDS);
    }

    @Test
    void isReadFromALineThatWasBrokenInCopying() {
        String whole = text("", "anna");

        assertThat(PairingCode.parse("  " + whole.substring(0, 40) + "\n   " + whole.substring(40) + "\n"))
                .isEqualTo(PairingCode.parse(whole));
    }

    @Test
    void hasOnlyCharactersThatEveryReaderOfQrCodesTakesAlike() {
        assertThat(text("10.0.0.7:5001", "Überläufer 漢")).matches("[!-~]+");
    }

    @Test
    void whatIsNoneIsNamed() {
        refused("https://example.org", "no pairing code of a boat");
        refused("", "no pairing code of a boat");
        refused(text("", "anna").replace("SAMI1", "SAMI2"), "of version 2, this program reads version 1");
    }

    @Test
    void whatIsDamagedIsNamed() {
        String whole = text("10.0.0.7:5001", "anna");
        refused(whole.substring(0, whole.lastIndexOf(';')), "has 4 parts, not 5");
        refused(whole.substring(0, whole.lastIndexOf(';') + 1), "1 to 100 printable characters");
        refused(whole.replace("able", "xxxx"), "'xxxx' is none of the words");
        refused(whole.replace("able.", ""), "six words are needed, not 5");
        refused(whole.replace("n4bQ", ""), "the key in it is not whole");
        refused(whole.replace("n4bQ", "!!!!"), "the key in it cannot be read");
        refused(whole.replace("10.0.0.7", "10 0 0 7\u0000"), "is no HOST:PORT");
        refused(whole.replace("anna", "%4"), "damaged");
        refused(whole + new String(new char[2000]), "too long");
    }

    @Test
    void wordsAreCompletedFromTheirFirstLetters() {
        assertThat(PairingSecret.beginningWith("Ab", 3)).containsExactly("able", "about", "above");
        assertThat(PairingSecret.beginningWith("abso", 3)).containsExactly("absolute");
        assertThat(PairingSecret.beginningWith("zzz", 3)).isEmpty();
    }

    private static void refused(String text, String why) {
        assertThatThrownBy(() -> PairingCode.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(why);
    }
}
