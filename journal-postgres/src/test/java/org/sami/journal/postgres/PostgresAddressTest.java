package org.sami.journal.postgres;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.journal.JournalAddress;

/** What a user may name as a journal in PostgreSQL. */
class PostgresAddressTest {
    @Test
    void readsHostPortDatabaseUserAndSchema() {
        PostgresAddress address = PostgresAddress.parse("postgresql://pilot@base-1:5433/boats?schema=lake_2");

        assertThat(address.url()).isEqualTo("jdbc:postgresql://base-1:5433/boats");
        assertThat(address.schema()).isEqualTo("lake_2");
        assertThat(address.properties()).containsEntry("user", "pilot").containsEntry("currentSchema", "lake_2");
        assertThat(address.words()).isEqualTo("postgresql://base-1:5433/boats?schema=lake_2");
        assertThat(PostgresAddress.parse("postgresql:///boats").url())
                .isEqualTo("jdbc:postgresql://localhost:5432/boats");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "postgresql://pilot:geheim7@localhost/boats",
                "postgresql://localhost/boats?user=pilot&password=geheim7",
                "postgresql://localhost/boats?sslpassword=geheim7"
            })
    void aPasswordIsRefusedAndNotRepeated(String text) {
        assertThatThrownBy(() -> JournalAddress.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("~/.pgpass")
                .message()
                .doesNotContain("geheim7");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "postgresql://localhost",
                "postgresql://localhost/",
                "postgresql://localhost/boats?options=-c",
                "postgresql://localhost/boats?user",
                "postgresql://localhost/boats?schema=Lake;DROP",
                "postgresql://local host/boats",
                "postgresql://localhost/bo/ats",
                "postgresql://localhost/boats#x"
            })
    void whatMakesNoSenseIsRefusedInOneSentence(String text) {
        assertThatThrownBy(() -> JournalAddress.parse(text))
                .isInstanceOf(IllegalArgumentException.class)
                .message()
                .isNotBlank()
                .doesNotContain("Exception");
    }

    @ParameterizedTest
    @CsvSource({
        "localhost, prefer",
        "127.0.0.1, prefer",
        "[::1], prefer",
        "base-1, verify-full",
        "10.0.0.7, verify-full"
    })
    void whatLeavesThisMachineIsEncryptedForAServerWhoseCertificateHolds(String host, String mode) {
        assertThat(PostgresAddress.parse("postgresql://" + host + "/boats").properties())
                .containsEntry("sslmode", mode);
    }

    @ParameterizedTest
    @ValueSource(strings = {"disable", "allow", "prefer", "require"})
    void lessIsRefusedOffThisMachine(String mode) {
        assertThatThrownBy(() -> PostgresAddress.parse("postgresql://base-1/boats?sslmode=" + mode))
                .hasMessageContaining("verify-full");
        assertThat(PostgresAddress.parse("postgresql://localhost/boats?sslmode=" + mode)
                        .properties())
                .containsEntry("sslmode", mode);
    }

    @Test
    void anUnknownKindOfDatabaseIsRefusedAndAFileStaysAFile() {
        assertThatThrownBy(() -> JournalAddress.parse("mysql://localhost/boats"))
                .hasMessageContaining("journals are files or postgresql://");
        assertThat(JournalAddress.parse("postgresql").file()).isPresent();
    }
}
