package org.sami.dreamm.tryout;

/** A step that was taken: its number, what was done, and what came of it. */
public record TryOutLine(int number, String done, String came) {}
