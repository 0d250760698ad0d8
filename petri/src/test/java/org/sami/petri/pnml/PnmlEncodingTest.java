package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PnmlEncodingTest {
    private static final String NAME = "Schl\u00fcssel \u00e6";
    private static final String NET = """
        <pnml xmlns="http://www.pnml.org/version-2009/grammar/pnml">
        <net id="n" type="http://www.pnml.org/version-2009/grammar/ptnet">
        <place id="p"><name><text>%s</text></name></place></net></pnml>
        """.formatted(NAME);

    private static PnmlReading read(byte[] file) {
        return PnmlReader.read(new ByteArrayInputStream(file), PnmlLimits.STANDARD);
    }

    @ParameterizedTest
    @CsvSource({
        "<?xml version='1.0'?>, UTF-8",
        "<?xml version='1.0' encoding='utf-8'?>, UTF-8",
        "'', UTF-8",
        "\ufeff<?xml version='1.0' encoding='UTF-8'?>, UTF-8",
        "\ufeff, UTF-8",
        "<?xml version='1.0' encoding='ISO-8859-1'?>, ISO-8859-1",
        "<?xml version='1.0' encoding='UTF-16'?>, UTF-16",
        "\ufeff<?xml version='1.0' encoding='UTF-16'?>, UTF-16LE"
    })
    void namesAreReadInTheEncodingOfTheFile(String head, String charset) {
        PnmlReading reading = read((head + NET).getBytes(Charset.forName(charset)));

        assertThat(reading.findings()).isEmpty();
        assertThat(reading.net().orElseThrow().placeName(0)).isEqualTo(NAME);
    }

    @Test
    void bytesThatAreNoUtf8AreAFindingAndNothingIsPrinted() {
        byte[] file = ("<?xml version='1.0'?>\n" + NET).getBytes(StandardCharsets.ISO_8859_1);
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        PrintStream before = System.err;
        PnmlReading reading;
        System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            reading = read(file);
        } finally {
            System.setErr(before);
        }

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings()).singleElement().satisfies(finding -> {
            assertThat(finding.code()).isEqualTo("E-XML");
            assertThat(finding.message()).startsWith("it is not written in UTF-8");
        });
        assertThat(printed.toString(StandardCharsets.UTF_8)).isEmpty();
    }
}
