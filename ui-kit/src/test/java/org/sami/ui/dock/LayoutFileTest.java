package org.sami.ui.dock;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LayoutFileTest {
    @TempDir
    private Path folder;

    private Path file(String text) throws IOException {
        return Files.writeString(folder.resolve("arrangement.xml"), text);
    }

    @Test
    void plainLayoutAndNoFileMayBeRead() throws IOException {
        assertThat(LayoutFile.fault(folder.resolve("none.xml"))).isEmpty();
        assertThat(LayoutFile.fault(file("<?xml version=\"1.0\"?><app-layout><layout a=\"1\"/></app-layout>")))
                .isEmpty();
    }

    @Test
    void documentTypeIsRefusedAndNothingIsFetched() throws Exception {
        AtomicInteger fetched = new AtomicInteger();
        try (ServerSocket server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            Thread thread = new Thread(() -> {
                try {
                    server.accept().close();
                    fetched.incrementAndGet();
                } catch (IOException closed) {
                    // nobody came
                }
            });
            thread.start();
            String url = "http://127.0.0.1:" + server.getLocalPort() + "/x.dtd";
            assertThat(LayoutFile.fault(file("<!DOCTYPE a SYSTEM \"" + url + "\"><app-layout/>")))
                    .contains("it has a document type");
            assertThat(LayoutFile.fault(
                            file("<!DOCTYPE a [<!ENTITY x SYSTEM \"" + url + "\">]><app-layout>&x;</app-layout>")))
                    .contains("it has a document type");
            server.close();
            thread.join();
        }
        assertThat(fetched).hasValue(0);
    }

    @Test
    void entitiesThatGrowAreNotWrittenOut() throws IOException {
        StringBuilder bomb = new StringBuilder("<!DOCTYPE a [<!ENTITY e0 \"xxxxxxxxxx\">");
        for (int i = 1; i < 12; i++) {
            bomb.append("<!ENTITY e")
                    .append(i)
                    .append(" \"")
                    .append(("&e" + (i - 1) + ";").repeat(10))
                    .append("\">");
        }
        assertThat(LayoutFile.fault(file(bomb + "]><app-layout>&e11;</app-layout>")))
                .contains("it has a document type");
    }

    @Test
    void whatIsNoXmlOrTooLargeIsRefused() throws IOException {
        assertThat(LayoutFile.fault(file("no layout")).orElseThrow()).startsWith("it is no XML");
        assertThat(LayoutFile.fault(file("<a>" + "x".repeat(2 << 20) + "</a>")).orElseThrow())
                .startsWith("it has more than");
    }
}
