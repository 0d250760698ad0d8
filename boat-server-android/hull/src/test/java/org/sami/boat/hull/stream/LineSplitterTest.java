package org.sami.boat.hull.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class LineSplitterTest {
    private final List<String> lines = new ArrayList<>();
    private final LineSplitter splitter = new LineSplitter(576, lines::add);

    private void feed(String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        splitter.feed(bytes, bytes.length);
    }

    @Test
    void linesThatComeInPiecesAreWhole() {
        feed("{\"m0\":");
        feed("1}\r");
        feed("\n\r\n{}\n");

        assertThat(lines).containsExactly("{\"m0\":1}", "{}");
    }

    @Test
    void fortyLinesAtOnceAreFortyLines() {
        feed("{\"m0\":{\"v\":0}}\r\n".repeat(40));

        assertThat(lines).hasSize(40).containsOnly("{\"m0\":{\"v\":0}}");
    }

    @Test
    void megabyteWithoutALineEndIsDroppedAndTheNextLineIsRead() {
        byte[] megabyte = new byte[1_000_000];
        Arrays.fill(megabyte, (byte) 'x');

        splitter.feed(megabyte, megabyte.length);
        feed("\r\nafter\r\n");

        assertThat(lines).containsExactly("after");
        assertThat(splitter.dropped()).isEqualTo(1);
    }

    @Test
    void longestLinePassesAndOneByteMoreDoesNot() {
        feed("a".repeat(576) + "\n" + "b".repeat(577) + "\nc\n");

        assertThat(lines).containsExactly("a".repeat(576), "c");
    }
}
