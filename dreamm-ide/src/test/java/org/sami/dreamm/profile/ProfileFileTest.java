package org.sami.dreamm.profile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandRegistry;

class ProfileFileTest {
    @TempDir
    private Path folder;

    @Test
    void hidesAndLocksByIdAndKeepsExceptions() throws IOException {
        Profile profile = read("""
                {"formatVersion": 1, "name": "Lesson 2", "hide": ["requirement-*"], "lock": ["project-*"],
                 "keep": ["requirement-generic", "project-save"]}
                """);

        assertThat(profile.shows("requirement-relevant")).isFalse();
        assertThat(profile.allows("requirement-generic")).isTrue();
        assertThat(profile.shows("project-open")).isTrue();
        assertThat(profile.allows("project-open")).isFalse();
        assertThat(profile.whyLocked("project-open")).contains("the profile Lesson 2 does not have it");
        assertThat(profile.allows("project-save")).isTrue();
        assertThat(profile.allows("undo")).isTrue();
    }

    @Test
    void aHiddenCommandIsNowhereAndALockedOneSaysWhy() {
        CommandRegistry commands = new CommandRegistry(
                new Profile("Lesson", java.util.List.of("hidden"), java.util.List.of("locked"), java.util.List.of()));
        Command hidden = commands.add(new Command("hidden", "Hidden", () -> {}).withKey("F7"));
        Command locked = commands.add(new Command("locked", "Locked", () -> {}));

        assertThat(commands.all()).containsExactly(locked);
        assertThat(commands.ofKey(hidden.key().orElseThrow())).isEmpty();
        assertThat(locked.isEnabled()).isFalse();
        assertThat(locked.whyNot()).contains("the profile Lesson does not have it");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "[]|it is no object",
                "{\"formatVersion\": 2, \"name\": \"x\"}|its \"formatVersion\" is not 1",
                "{\"formatVersion\": 1}|its \"name\" is missing",
                "{\"formatVersion\": 1, \"name\": \"x\", \"hidden\": []}|a member \"hidden\"",
                "{\"formatVersion\": 1, \"name\": \"x\", \"hide\": [\"Big Id\"]}|which is no id",
                "{\"formatVersion\": 1, \"name\": }|is not JSON, line 1"
            })
    void whatIsNoProfileIsRefusedInOneLine(String text, String why) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(IOException.class)
                .hasMessageContaining("profile.json")
                .hasMessageContaining(why)
                .hasMessageNotContaining("\n");
    }

    private Profile read(String text) throws IOException {
        Path file = folder.resolve("profile.json");
        Files.writeString(file, text);
        return ProfileFile.read(file);
    }
}
