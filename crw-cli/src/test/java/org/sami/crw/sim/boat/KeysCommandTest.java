package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.session.server.ServerAddress;

/** {@code crw keys} at a boat with keys: who is paired commands it, who was withdrawn does not. */
@Tag("long")
@Timeout(900)
@Isolated("what --keys says holds for the whole process")
class KeysCommandTest {
    @TempDir
    private Path folder;

    private final SteadyClock clock = new SteadyClock(ProcessClock::ms);
    private final List<String> codes = new CopyOnWriteArrayList<>();
    private KeyRing keys;
    private PairingResponder responder;
    private BoatOnTcp boat;

    @BeforeEach
    void launch() throws IOException {
        keys = new KeyStoreFolder(folder.resolve("anna-keys")).open();
        responder = new PairingResponder(keys, (base, code) -> codes.add(code));
        BoatSettings settings = BoatSettings.of("anna", TcpTestFleet.port(0), TcpTestFleet.PIER, 1);
        boat = new BoatOnTcp(settings, clock, TcpServerListener.NONE, plain -> plain.withKeys(keys, responder));
    }

    @AfterEach
    void close() throws IOException {
        new BaseProtection(Optional.empty(), false).use();
        boat.close();
    }

    private String address() {
        return "127.0.0.1:" + boat.address().getPort();
    }

    private String[] with(String folderName, String... words) {
        List<String> all = new ArrayList<>(List.of(words));
        all.add("--keys");
        all.add(folder.resolve(folderName).toString());
        return all.toArray(String[]::new);
    }

    private CommandResult pair(String folderName, PairingSecret words) {
        return CommandResult.crw(with(folderName, "keys", "pair", address(), "--words", words.toString()));
    }

    @Test
    void pairedBaseStopsTheBoatAndAStrangerIsToldToPair() {
        assertThat(pair("mine", responder.open(Role.COMMANDER, clock.getAsLong()))
                        .out())
                .contains(
                        "paired with anna, key " + keys.identity().fingerprint().shortText())
                .contains("check code " + codes.get(0));

        CommandResult stopped = CommandResult.crw(with("mine", "stop", "--within", "60", address()));
        CommandResult stranger = CommandResult.crw(with("none", "stop", address(), "--within", "12"));

        assertThat(stopped.out()).contains("anna: stopped, and the stop is latched");
        assertThat(stranger.exitCode()).isEqualTo(4);
        assertThat(stranger.out()).contains("no answer").contains("crw keys pair");
    }

    @Test
    void wrongWordsAreRefusedWithTheReasonAndNothingIsKept() {
        responder.open(Role.COMMANDER, clock.getAsLong());

        CommandResult refused = pair("mine", PairingSecret.random());

        assertThat(refused.exitCode()).isNotZero();
        assertThat(refused.err())
                .contains("anna: the words are not those that the boat shows")
                .contains("4 tries");
        assertThat(CommandResult.crw(with("mine", "keys", "list")).out()).doesNotContain("boat anna");
        assertThat(keys.peers()).isEmpty();
    }

    @Test
    void listHasTheCertificateWithWhichTheBaseServesSessions() throws IOException {
        String listed = CommandResult.crw(with("mine", "keys", "list")).out();

        String print =
                ServerAddress.print(new BaseKeys(folder.resolve("mine")).open().identity());
        assertThat(listed).contains(print + "  its certificate, where it serves a session");
    }

    @Test
    void keysGoToASecondLaptopInAFileThatOnlyItsPasswordOpens() throws IOException {
        pair("mine", responder.open(Role.COMMANDER, clock.getAsLong()));
        Path file = folder.resolve("fleet.keys");
        Path password = Files.writeString(folder.resolve("password"), "in the boat house\n");
        Path other = Files.writeString(folder.resolve("other"), "in the other house\n");
        CommandResult.crw(with("mine", "keys", "export", "" + file, "--password-file", "" + password));

        CommandResult wrong =
                CommandResult.crw(with("second", "keys", "import", "" + file, "--password-file", "" + other));
        CommandResult right =
                CommandResult.crw(with("second", "keys", "import", "" + file, "--password-file", "" + password));

        assertThat(wrong.err()).contains("the password is another one, or the file is damaged");
        assertThat(right.out()).contains("and 1 boats now");
        assertThat(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1))
                .doesNotContain("anna");
        assertThat(CommandResult.crw(with("second", "stop", "--within", "60", address()))
                        .out())
                .contains("anna: stopped");
    }

    @Test
    void withdrawnKeyIsCarriedToTheBoatByABaseThatCommandsIt() throws IOException {
        pair("lost", responder.open(Role.COMMANDER, clock.getAsLong()));
        pair("mine", responder.open(Role.COMMANDER, clock.getAsLong()));
        String lost = new KeyStoreFolder(folder.resolve("lost"))
                .open()
                .identity()
                .fingerprint()
                .toString();
        CommandResult.crw(with("mine", "stop", "--within", "60", address()));

        CommandResult.crw(with("mine", "keys", "withdraw", lost));
        CommandResult released =
                CommandResult.crw(with("mine", "stop", "--release", "--confirm", "--within", "60", address()));

        assertThat(released.exitCode()).as(released.out() + released.err()).isZero();
        CommandResult thief = CommandResult.crw(with("lost", "stop", address(), "--within", "12"));
        assertThat(thief.exitCode()).isEqualTo(4);
        assertThat(thief.out()).contains("withdrawn from anna");
    }

    @Test
    void missionRunsOnABoatWithKeysAsOnAnyOther() {
        pair("mine", responder.open(Role.COMMANDER, clock.getAsLong()));

        CommandResult ran = CommandResult.crw(with(
                "mine",
                "run",
                "clv",
                "--connect",
                address(),
                "--area",
                "20",
                "--locations",
                "2",
                "--answer-after",
                "0.2",
                "--for",
                "120",
                "--json"));

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out())
                .containsPattern("\"outcome\" ?: ?\"ended\"")
                .containsPattern("\"locationsVisited\" ?: ?2");
    }

    private String code(KeyRing of, PairingSecret words) {
        return new PairingCode(address(), "anna", of.identity().fingerprint(), words).toString();
    }

    @Test
    void textOfTheQrCodeIsEnoughToPair() {
        PairingSecret words = responder.open(Role.COMMANDER, clock.getAsLong());

        CommandResult paired = CommandResult.crw(with("mine", "keys", "pair", "--words", code(keys, words)));

        assertThat(paired.out()).contains("paired with anna").contains("check code " + codes.get(0));
    }

    @Test
    void qrCodeOfAnotherBoatIsRefusedBeforeAnythingIsProved() {
        PairingSecret words = responder.open(Role.COMMANDER, clock.getAsLong());

        CommandResult refused =
                CommandResult.crw(with("mine", "keys", "pair", "--words", code(KeyRing.inMemory(), words)));

        assertThat(refused.exitCode()).isEqualTo(4);
        assertThat(refused.err()).contains("it is another boat, maybe of another fleet");
        assertThat(keys.peers()).isEmpty();
        assertThat(pair("mine", words).out()).contains("paired with anna");
    }

    @Test
    void baseThatWishesToObserveIsGrantedNoMore() {
        PairingSecret words = responder.open(Role.COMMANDER, clock.getAsLong());

        CommandResult paired =
                CommandResult.crw(with("mine", "keys", "pair", address(), "--observer", "--words", words.toString()));

        assertThat(paired.out()).contains("as an observer");
        assertThat(keys.peers()).extracting(peer -> peer.role()).containsExactly(Role.OBSERVER);
    }

    @Test
    void baseThatIsPairedAlreadyIsToldSoWhereTheBoatShowsNoWords() {
        pair("mine", responder.open(Role.COMMANDER, clock.getAsLong()));

        CommandResult again = pair("mine", PairingSecret.random());

        assertThat(again.err()).contains("begin the pairing anew at the boat").contains("is paired with anna already");
    }
}
