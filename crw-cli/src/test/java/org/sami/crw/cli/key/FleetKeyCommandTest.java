package org.sami.crw.cli.key;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.key.FleetKey;
import org.sami.mavlink.testing.SmallVehicle;

/** {@code crw keys fleet}, and {@code crw vehicles} with its key. */
@Tag("long")
@Timeout(900)
class FleetKeyCommandTest {
    @TempDir
    private Path folder;

    private CommandResult keys(String command, Path keys, String... more) {
        String[] all = new String[4 + more.length];
        all[0] = "keys";
        all[1] = command;
        System.arraycopy(more, 0, all, 2, more.length);
        all[all.length - 2] = "--keys";
        all[all.length - 1] = keys.toString();
        return CommandResult.crw(all);
    }

    @Test
    void keyIsMadeOnceListedAndMovedWithTheOthers() throws Exception {
        Path one = folder.resolve("one");
        Path two = folder.resolve("two");
        Path password = Files.writeString(folder.resolve("password"), "a long password\n");
        CommandResult made = keys("fleet", one);
        assertThat(made.exitCode()).as(made.err()).isZero();
        assertThat(made.out()).matches("[0-9a-f]{16}  this fleet\\R");
        assertThat(keys("fleet", one).out()).isEqualTo(made.out());
        String print = made.out().substring(0, 16);
        assertThat(new BaseKeys(one).shownFleetKey().map(FleetKey::fingerprint))
                .as("as a window shows it")
                .contains(print);
        assertThat(keys("list", one).out()).contains(print + "  fleet of vehicles");

        Path file = folder.resolve("fleet.keys");
        CommandResult out = keys("export", one, file.toString(), "--password-file", password.toString());
        assertThat(out.exitCode()).as(out.err()).isZero();
        CommandResult in = keys("import", two, file.toString(), "--password-file", password.toString());
        assertThat(in.exitCode()).as(in.err()).isZero();
        assertThat(keys("fleet", two).out()).isEqualTo(made.out());
    }

    @Test
    void newKeyTakesThePlaceOfTheOneThatALostLaptopHas() {
        String old = keys("fleet", folder).out();

        CommandResult made = keys("fleet", folder, "--new");

        assertThat(made.exitCode()).as(made.err()).isZero();
        assertThat(made.out()).matches("[0-9a-f]{16}  this fleet\\R").isNotEqualTo(old);
        assertThat(keys("fleet", folder).out()).isEqualTo(made.out());
    }

    @Test
    void vehicleThatDoesNotSignIsRefusedAndSaid() throws Exception {
        keys("fleet", folder);
        try (SmallVehicle vehicle = new SmallVehicle(7, 0, false)) {
            CommandResult ran = CommandResult.crw(
                    "vehicles", "--for", "10", "--signed", "--keys", folder.toString(), vehicle.address());

            assertThat(ran.exitCode()).isEqualTo(4);
            assertThat(ran.out())
                    .contains("no vehicle was heard")
                    .containsPattern("refused \\d+ messages? without a signature");
        }
    }

    @Test
    void signingWithoutAKeyIsRefusedWithWhatMakesOne() {
        CommandResult ran = CommandResult.crw(
                "vehicles", "--signed", "--keys", folder.resolve("none").toString(), "mavlink:udp:14999");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("crw keys fleet makes one");
    }

    @Test
    void budgetIsComputedWithoutALink() {
        CommandResult ran = CommandResult.crw("vehicles", "--budget-for", "25", "mavlink:serial:/dev/ttyUSB0:57600");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out())
                .contains("25 vehicles, each asked for:")
                .containsPattern("GLOBAL_POSITION_INT +every +0\\.\\d\\d s")
                .contains("4032 of 5760 bytes/s together: 70 % of the link");
    }
}
