package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class BoundedFileTest {
    @TempDir
    Path folder;

    private Path file;

    private Path file(String text) throws Exception {
        file = folder.resolve("file");
        return Files.writeString(file, text);
    }

    @Test
    void fileUpToTheLimitIsReadWhole() throws Exception {
        assertThat(BoundedFile.text(file("12345"), 5)).isEqualTo("12345");
        assertThat(BoundedFile.text(file("\uFEFFab"), 10)).isEqualTo("ab");
        assertThat(BoundedFile.bytes(file(""), 5)).isEmpty();
    }

    @Test
    void largerOneIsRefusedByName() throws Exception {
        assertThatThrownBy(() -> BoundedFile.text(file("123456"), 5))
                .isInstanceOf(FileTooLargeException.class)
                .hasMessage(file + " is larger than 5 bytes, and is not read");
    }

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void deviceWithoutAnEndIsGivenUpAtTheLimit() {
        assertThatThrownBy(() -> BoundedFile.bytes(Path.of("/dev/zero"), BoundedFile.SETTINGS_BYTES))
                .hasMessage("/dev/zero is larger than 1 MB, and is not read");
    }

    @Test
    void memoryThatDoesNotSufficeIsAFaultOfTheFile() throws Exception {
        Path large = file("x");

        assertThatThrownBy(() -> BoundedFile.making(large, () -> {
                    throw new OutOfMemoryError("Java heap space");
                }))
                .isInstanceOf(FileTooLargeException.class)
                .hasMessageContaining(large + " needs more memory than the ")
                .hasMessageContaining("JAVA_OPTS=-Xmx4g");
    }

    @Test
    void whatIsNoUtf8IsToldAsSuch() throws Exception {
        Path binary = Files.write(folder.resolve("binary"), new byte[] {(byte) 0xff, (byte) 0xfe});

        assertThatThrownBy(() -> BoundedFile.text(binary, 5)).isInstanceOf(CharacterCodingException.class);
    }
}
