package org.sami.boat.hull.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class BoardLinesTest {
    private final List<String> said = new ArrayList<>();
    private final BoardLines lines = new BoardLines(new BoardLines.Reader() {
        @Override
        public void motor(int number, double velocity) {
            said.add("m" + number + "=" + velocity);
        }

        @Override
        public void sensor(String slot, String type, String data) {
            said.add(slot + " " + type + " " + data);
        }

        @Override
        public void error(String error, String arguments) {
            said.add("error " + error + " " + arguments);
        }

        @Override
        public void garbled(String line) {
            said.add("garbled");
        }
    });

    @Test
    void motorsSensorsAndErrorsAreRead() {
        assertThat(lines.read("{\"m0\":{\"v\":0.5,\"c\":1.2},\"m1\":{\"v\":-1,\"c\":0}}"))
                .isTrue();
        lines.read("{\"s4\":{\"type\":\"battery\",\"data\":\"12.463 9045.454102 0.000000\"}}");
        lines.read("{\"error\":\"buffer\",\"args\":\"m0\"}");

        assertThat(said)
                .containsExactly("m0=0.5", "m1=-1.0", "s4 battery 12.463 9045.454102 0.000000", "error buffer m0");
    }

    @Test
    void missingNumberIsNoNumber() {
        lines.read("{\"m0\":{\"c\":1.2}}");

        assertThat(said).containsExactly("m0=NaN");
    }

    @Test
    void lineWithNanIsGarbled() {
        assertThat(lines.read("{\"m0\":{\"v\":NaN}}")).isFalse();
        assertThat(said).containsExactly("garbled");
    }

    @Test
    void wholeObjectBehindAHalfOneIsRead() {
        assertThat(lines.read("{\"m0\":{\"v\":0.{\"s1\":{\"type\":\"es2\",\"data\":\"400 18.1\"}}"))
                .isTrue();
        assertThat(said).containsExactly("s1 es2 400 18.1");
    }

    @Test
    void innerObjectOfADamagedLineIsNoLine() {
        assertThat(lines.read("\"m0\":{\"v\":0.5,\"c\":1.2}}")).isFalse();
        assertThat(said).containsExactly("garbled");
    }

    @Test
    void noGarbageBreaksTheReader() {
        SplittableRandom random = new SplittableRandom(1);
        String alphabet = "{}[]\":,.0123456789mvsdatype NaN\\u\u0001";
        for (int i = 0; i < 20_000; i++) {
            StringBuilder line = new StringBuilder();
            for (int length = random.nextInt(80); length > 0; length--) {
                line.append(alphabet.charAt(random.nextInt(alphabet.length())));
            }
            lines.read(line.toString());
        }
        said.clear();

        assertThat(lines.read("{\"m0\":{\"v\":1}}")).isTrue();
    }

    @Test
    void deepNestingIsGarbled() {
        assertThat(lines.read("{\"m0\":".repeat(90))).isFalse();
    }
}
