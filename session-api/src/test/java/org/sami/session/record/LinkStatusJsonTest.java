package org.sami.session.record;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.gateway.LinkStatus;

class LinkStatusJsonTest {
    @Test
    void linksAreReadAsTheyWereWritten() {
        List<LinkStatus> links = List.of(
                new LinkStatus(
                        "mavlink:serial:/dev/ttyUSB0:57600",
                        true,
                        0.04,
                        120,
                        Optional.empty(),
                        Optional.of(180),
                        Optional.of(0),
                        449.5,
                        OptionalDouble.of(0.08)),
                new LinkStatus(
                        "mavlink:udp:14550",
                        false,
                        1,
                        7_400,
                        Optional.of("it is closed"),
                        Optional.empty(),
                        Optional.empty(),
                        0,
                        OptionalDouble.empty()));

        assertThat(LinkStatusJson.read(LinkStatusJson.write(links))).isEqualTo(links);
    }

    @Test
    void nothingIsReadFromAServerThatTellsNone() {
        assertThat(LinkStatusJson.read(JsonNodeFactory.instance.missingNode())).isEmpty();
    }
}
