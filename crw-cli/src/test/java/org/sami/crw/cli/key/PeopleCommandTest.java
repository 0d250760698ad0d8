package org.sami.crw.cli.key;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.cli.CommandResult;

class PeopleCommandTest {
    @TempDir
    private Path folder;

    private String list() {
        return folder.resolve("people").toString();
    }

    @Test
    void keyIsPrintedOnceAndStoredAsAHash() throws Exception {
        CommandResult added = CommandResult.crw("people", "add", "anna", "--role", "operator", "--people", list());
        String key = added.out().lines().reduce((one, next) -> next).orElseThrow();

        assertThat(added.exitCode()).isZero();
        assertThat(key.split(" ")).hasSize(6);
        assertThat(Files.readString(folder.resolve("people"))).doesNotContain(key);
        assertThat(CommandResult.crw("people", "list", "--people", list()).out())
                .isEqualToIgnoringNewLines("anna  operator");
        assertThat(CommandResult.crw("people", "remove", "anna", "--people", list())
                        .exitCode())
                .isZero();
        assertThat(CommandResult.crw("people", "list", "--people", list()).out())
                .startsWith("nobody is listed");
    }

    @Test
    void wrongRolesAndNamesAreUsageFaults() throws Exception {
        assertThat(CommandResult.crw("people", "add", "anna", "--role", "captain", "--people", list())
                        .err())
                .contains("'captain' is none of operator, pilot, observer");
        assertThat(CommandResult.crw("people", "add", "an na", "--role", "pilot", "--people", list())
                        .exitCode())
                .isEqualTo(2);
        assertThat(CommandResult.crw("people", "remove", "ben", "--people", list())
                        .err())
                .contains("nobody here is named 'ben'");
    }

    @Test
    void anotherRoleIsGivenWithoutAnotherKey() throws Exception {
        CommandResult.crw(
                "people", "add", "ben", "--role", "pilot", "--decisions", "OperatorApprove", "--people", list());
        String before = Files.readString(folder.resolve("people"));

        CommandResult changed = CommandResult.crw("people", "role", "ben", "operator", "--people", list());

        assertThat(changed.exitCode()).isZero();
        assertThat(changed.out()).isEqualToIgnoringNewLines("ben is operator; before: pilot  OperatorApprove");
        assertThat(CommandResult.crw("people", "list", "--people", list()).out())
                .isEqualToIgnoringNewLines("ben  operator");
        CommandResult.crw("people", "role", "ben", "pilot", "--decisions", "OperatorApprove", "--people", list());
        assertThat(folder.resolve("people")).hasContent(before);
    }

    @Test
    void unknownRolesAndPeopleAreNotChanged() throws Exception {
        CommandResult.crw("people", "add", "ben", "--role", "pilot", "--people", list());

        CommandResult role = CommandResult.crw("people", "role", "ben", "captain", "--people", list());
        CommandResult name = CommandResult.crw("people", "role", "carl", "pilot", "--people", list());

        assertThat(role.exitCode()).isEqualTo(2);
        assertThat(role.err()).contains("ROLE: 'captain' is none of operator, pilot, observer");
        assertThat(name.exitCode()).isEqualTo(2);
        assertThat(name.err()).contains("nobody here is named 'carl'");
        assertThat(CommandResult.crw("people", "list", "--people", list()).out())
                .isEqualToIgnoringNewLines("ben  pilot");
    }

    @Test
    void serverRefusesAListThatIsNotThere() {
        CommandResult served = CommandResult.crw("serve", "--port", "0", "--people", list());

        assertThat(served.exitCode()).isEqualTo(2);
        assertThat(served.err()).contains("there is no list");
    }

    @Test
    void baseWithoutItsCertificateIsRefusedBeforeASessionIsBegun() {
        Path journal = folder.resolve("session.journal");
        CommandResult served = CommandResult.crw(
                "serve", "--port", "0", "--journal", journal.toString(), "--bases", "wss://10.0.0.5:8443");

        assertThat(served.exitCode()).isEqualTo(2);
        assertThat(served.err()).contains("--bases: wss://10.0.0.5:8443 needs the SHA-256 of that base's certificate");
        assertThat(journal).doesNotExist();
    }

    @Test
    void baseForOtherMachinesWithoutPeopleIsRefusedBeforeASessionIsBegun() {
        Path journal = folder.resolve("session.journal");
        CommandResult served =
                CommandResult.crw("serve", "--port", "0", "--host", "0.0.0.0", "--journal", journal.toString());

        assertThat(served.exitCode()).isEqualTo(2);
        assertThat(served.err())
                .contains("--host 0.0.0.0: without people a session is served on this machine only")
                .contains("'crw people add NAME'");
        assertThat(journal).doesNotExist();
    }
}
