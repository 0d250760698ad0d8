package org.sami.boat.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The page about the link, docs/link.md, says what the code does. */
class LinkPageTest {
    private static final Pattern EXAMPLE = Pattern.compile("^\\| `(\\{.*?})` \\|", Pattern.MULTILINE);

    private static String page() throws IOException {
        return Files.readString(Path.of("..", "docs", "link.md"));
    }

    static List<String> examples() throws IOException {
        return EXAMPLE.matcher(page()).results().map(found -> found.group(1)).toList();
    }

    @ParameterizedTest
    @MethodSource("examples")
    void exampleIsAMessageWithEveryMemberAndNoOther(String example) throws LinkException {
        LinkCodec codec = new LinkCodec();
        Frame frame = codec.decode(MalformedFrameTest.frame(example));

        byte[] written = codec.encode(frame);
        int header = LinkCodec.HEADER_BYTES;
        String body = new String(written, header, written.length - header, StandardCharsets.UTF_8);
        assertThat(body.replaceAll("\\.0(?=[,}\\]])", "")).isEqualTo(example);
    }

    @Test
    void everyMessageHasAnExample() throws IOException {
        Pattern type = Pattern.compile("\"type\":\"([^\"]+)\"");
        TreeSet<String> shown = new TreeSet<>();
        for (String example : examples()) {
            Matcher found = type.matcher(example);
            assertThat(found.find()).isTrue();
            shown.add(found.group(1));
        }

        assertThat(shown).isEqualTo(new TreeSet<>(MessageReaders.types()));
    }

    @Test
    void everyReasonModeAndActionIsExplained() throws IOException {
        String page = page();
        Stream.of(
                        NackReason.values(),
                        BoatMode.values(),
                        LostLinkAction.values(),
                        GainAxis.values(),
                        FileRefusal.Reason.values())
                .flatMap(Arrays::stream)
                .forEach(word -> assertThat(page).contains("`" + word + "`"));
        for (BatteryLevel level : BatteryLevel.values()) {
            assertThat(page).contains("`" + level + "`");
        }
    }

    @Test
    void quotedRefusalAndBoundAreThoseOfTheCode() throws IOException {
        String bad =
                "{\"type\":\"upload\",\"seq\":0,\"command\":\"c\",\"list\":\"l\",\"waypoints\":[[1,1,1],[99,1,1]]}";
        String[] said = new String[1];
        assertThatThrownBy(() -> new LinkCodec().decode(MalformedFrameTest.frame(bad)))
                .satisfies(refused -> said[0] = refused.getMessage());

        assertThat(page()).contains("`" + said[0] + "`").contains("1 to 4,194,304");
        assertThat(LinkCodec.DEFAULT_MAX_BYTES).isEqualTo(4_194_304);
    }
}
