package org.sami.spn.geotext;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.value.GeoPoint;

class GeoTextReaderTest {
    @Test
    void barePointIsAPoint() {
        GeoText text = read("# quay\n 45.5 , 10.25 \n").text().orElseThrow();

        assertThat(text.nesting()).isZero();
        assertThat(text.lists().get(0).points()).containsExactly(GeoPoint.of(45.5, 10.25));
    }

    @Test
    void bracketHoldsAListAndItsLinesAreKnown() {
        GeoText text = read("#\n\n[\n1,2\n# between\n3,4\n]\n").text().orElseThrow();

        assertThat(text.nesting()).isEqualTo(1);
        assertThat(text.lists()).hasSize(1);
        assertThat(text.lists().get(0).line()).isEqualTo(3);
        assertThat(text.lists().get(0).points()).containsExactly(GeoPoint.of(1, 2), GeoPoint.of(3, 4));
    }

    @Test
    void bracketsInABracketAreListsInTheirOrder() {
        GeoText text = read("[\n[\n1,2\n]\n[\n3,4\n5,6\n]\n]\n").text().orElseThrow();

        assertThat(text.nesting()).isEqualTo(2);
        assertThat(text.lists()).extracting(list -> list.points().size()).containsExactly(1, 2);
        assertThat(text.words()).isEqualTo("a list of 2 lists of points");
    }

    @Test
    void missingLastBracketIsSaidAndForgiven() {
        GeoTextReader.Result result = read("[\n[\n1,2\n]\n[\n3,4\n]");

        assertThat(result.text()).isPresent();
        assertThat(result.findings()).singleElement().satisfies(finding -> {
            assertThat(finding.isError()).isFalse();
            assertThat(finding.line()).isEqualTo(7);
            assertThat(finding.message()).contains("']' is missing");
        });
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "                        | 1 | no point",
                "'# nothing'             | 1 | no point",
                "'[;]'                   | 2 | no points",
                "'[;1,2'                 | 2 | has no ']'",
                "'[;[;1,2;]'             | 4 | ",
                "'[;1,2;[;3,4;]'         | 3 | not both",
                "'[;[;1,2;];3,4;]'       | 5 | not both",
                "'[;[;[;1,2;];];]'       | 3 | at most two deep",
                "']'                     | 1 | no '[' that this",
                "'[;1,2;];[;3,4;]'       | 4 | a file holds one",
                "'[;1,2,3;]'             | 2 | not '1,2,3'",
                "'[;here;]'              | 2 | not 'here'",
                "'[;1,x;]'               | 2 | in degrees",
                "'[;91,2;]'              | 2 | Latitude",
                "'[;1,181;]'             | 2 | Longitude",
                "'[;NaN,181;]'           | 2 | Latitude",
            })
    void whatIsWrongIsNamedByItsLine(String lines, int line, String message) {
        GeoTextReader.Result result = read(lines == null ? "" : lines.replace(';', '\n'));

        assertThat(result.findings()).isNotEmpty();
        assertThat(result.findings().get(0).line()).isEqualTo(line);
        if (message == null) {
            assertThat(result.text()).as("only the last bracket is missing").isPresent();
        } else {
            assertThat(result.text()).isEmpty();
            assertThat(result.findings().get(0).message()).contains(message);
        }
    }

    @Test
    void everyWrongLineIsNamedAtOnce() {
        assertThat(read("[\na\n1,2\nb\n]").findings())
                .extracting(LineFinding::line)
                .isEqualTo(List.of(2, 4));
    }

    @Test
    void whatIsNoTextIsRefused() {
        GeoTextReader.Result result = GeoTextReader.read(new byte[] {'[', (byte) 0xFF, 0, 1});

        assertThat(result.text()).isEmpty();
        assertThat(result.findings().get(0).message()).contains("no text file");
    }

    private static GeoTextReader.Result read(String text) {
        return GeoTextReader.read(text.getBytes(StandardCharsets.UTF_8));
    }
}
